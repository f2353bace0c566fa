// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_preflight_h
#define signorini_simulation_preflight_h

#include <signorini/simulation/first_impacts.h>
#include <signorini/simulation/memory_estimate.h>

#include <string>
#include <vector>

namespace signorini
{
  /** A body as waves see it; times in units of the scene. */
  struct BodyForecast
  {
    std::string name;
    double      pressure_wave_speed = 0., shear_wave_speed = 0.;
    double      transit_time     = 0.; ///< of a pressure wave through its largest extent
    double      vibration_period = 0.; ///< longitudinal, along the same extent; bending is slower
  };

  /** A first impact, and the steps and the mesh that it wants. */
  struct ImpactForecast
  {
    std::string pair;
    FirstImpact first;
    double      n_steps                  = 0.; ///< in contact, with the present step size
    double      recommended_step_size    = 0.;
    double      recommended_node_spacing = 0.; ///< round bodies only, otherwise 0
  };

  /** All that is known about a run before its first step. */
  struct Preflight
  {
    std::string                 scene, scheme, law;
    unsigned int                dimension = 0, n_processes = 0;
    double                      step_size = 0., end_time = 0.;
    bool                        has_inertia = true, variable_steps = false;
    unsigned int                n_steps = 0, contact_nodes = 0;
    unsigned long               cells = 0, dofs = 0;
    double                      courant_number = 0.;
    MemoryEstimate              memory;
    std::vector<BodyForecast>   bodies;
    std::vector<ImpactForecast> impacts;
    /** For twenty steps in the shortest contact, or else in the shortest transit of a wave. */
    double                   recommended_step_size = 0.;
    std::vector<std::string> skipped; ///< what the run will not do or write, a clause each
    std::vector<std::string> notes, warnings;
  };

  /**
   * Everything but notes and warnings. Collective.
   * @param impacts see first_impacts()
   */
  template <int dim>
  Preflight preflight(const Scene<dim>               &scene,
                      const MeshedScene<dim>         &meshed,
                      const std::vector<FirstImpact> &impacts);

  /** Lines of text for people. */
  std::string in_words(const Preflight &preflight);

  /** The same as an object of JSON; what is not known or infinite is null. */
  std::string as_json(const Preflight &preflight);
} // namespace signorini

#endif
