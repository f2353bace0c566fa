// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_scene_h
#define signorini_scene_scene_h

#include <signorini/base/enum_names.h>
#include <signorini/model/adaptivity_parameters.h>
#include <signorini/model/body_description.h>
#include <signorini/model/cell_geometry.h>
#include <signorini/model/contact_description.h>
#include <signorini/model/exact_solution.h>
#include <signorini/model/point_probe.h>
#include <signorini/model/run_parameters.h>
#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/scene/step_size_parameters.h>
#include <signorini/scene/time_parameters.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /** What `Mapping` says. */
  enum class MappingChoice
  {
    automatic, ///< by the bodies, and whether the mesh changes
    linear,
    curved
  };

  template <>
  struct EnumNames<MappingChoice>
  {
    static constexpr EnumName<MappingChoice> table[] = {{MappingChoice::automatic, "automatic"},
                                                        {MappingChoice::linear, "linear"},
                                                        {MappingChoice::curved, "curved"}};
  };

  /**
   * All that a scene file says, checked. Plain data: built by read_scene(), and taken apart by the
   * simulation: nobody else sees it.
   */
  template <int dim>
  struct Scene
  {
    std::string                       file_name;
    std::string                       output_directory;
    CellGeometry                      mapping = CellGeometry::linear; ///< as it has been chosen
    TimeParameters                    time;
    AdaptivityParameters              adaptivity;
    std::vector<BodyDescription<dim>> bodies;
    std::vector<NamedObstacle<dim>>   obstacles;
    std::vector<PairDescription>      pairs;
    ContactMotion                     motion = ContactMotion::linearised;
    /** What has to be done so that contact follows the motion: a clause in the imperative. */
    std::string how_to_follow;
    std::string why_linearised; ///< why contact cannot follow the motion, if it shall where it can
    std::vector<ProbeDescription<dim>>      probes;
    std::vector<PointProbeDescription<dim>> point_probes;
    ExactSolutionDescription<dim>           exact_solution;
    SolverParameters                        solver;
    OutputParameters                        output;
    CheckpointParameters                    checkpoint;
    /** Meshes and plug-ins: keys, and paths from the root of the file system. */
    std::map<std::string, std::string>               input_files;
    std::vector<std::pair<std::string, std::string>> overrides; ///< as in CommandLine
    std::string original_text;  ///< the scene file and the command line, see repeatable_text()
    std::string all_parameters; ///< every key with the value used, as a .prm
    StepSizeParameters step_sizes;
  };
} // namespace signorini

#endif
