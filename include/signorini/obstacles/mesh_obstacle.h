// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_mesh_obstacle_h
#define signorini_obstacles_mesh_obstacle_h

#include <signorini/obstacles/faceted_obstacle.h>
#include <signorini/prm/section_reader.h>

#include <set>

namespace signorini
{
  /** `Shape = mesh`: a surface from a file, with its sides where it has inner corners. */
  template <int dim>
  class MeshObstacle : public FacetedObstacle<dim>
  {
  public:
    MeshObstacle(std::shared_ptr<const FacetedSurface<dim>> surface, std::string path = "");

    std::vector<std::shared_ptr<const RigidObstacle<dim>>> sides() const override { return parts; }
    std::vector<unsigned int> sides_near(const dealii::Point<dim> &start,
                                         const dealii::Point<dim> &end,
                                         double                    reach) const override;

    std::vector<std::array<dealii::Point<dim>, dim>> facets() const override;

    std::string file() const override { return path; }

  private:
    const std::string                                      path;
    std::vector<std::shared_ptr<const RigidObstacle<dim>>> parts;
    std::vector<std::set<unsigned int>> meeting; ///< sides that each side meets in inner corners
  };

  template <int dim>
  void declare_mesh_obstacle(dealii::ParameterHandler &prm);

  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_mesh_obstacle(const SectionReader &in,
                                                                const std::string   &name);
} // namespace signorini

#endif
