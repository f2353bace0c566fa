// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_first_impacts_h
#define signorini_simulation_first_impacts_h

#include <signorini/diagnostics/expected_impact.h>
#include <signorini/simulation/meshed_scene.h>

namespace signorini
{
  /** The first touch of a pair, and if there is a theory for it, what comes of it. */
  struct FirstImpact
  {
    unsigned int   pair         = 0;
    double         time         = 0.;    ///< of the scene
    double         speed        = 0.;    ///< of approach
    bool           is_known     = false; ///< whether the rest means anything
    bool           is_round     = false; ///< Hertz, otherwise a plane wave
    double         node_spacing = 0.;    ///< of the slave surface at that place
    ExpectedImpact impact       = {};
    double wave_transit = 0.; ///< where nothing is known: through a body and back, a duration
  };

  /**
   * The pairs that meet before the end of the run if bodies fly on as they start, see RigidFlight.
   * Nothing is known of the impact of edges and corners, of bodies that cannot give way, and where
   * a third body is between the sides and is hit before. Collective.
   */
  template <int dim>
  std::vector<FirstImpact>
  first_impacts(const Scene<dim> &scene, MeshedScene<dim> &meshed, const State &state);
} // namespace signorini

#endif
