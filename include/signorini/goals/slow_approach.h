// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_slow_approach_h
#define signorini_goals_slow_approach_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

#include <vector>

namespace signorini
{
  /** Density times volume. Collective. */
  template <int dim>
  std::vector<double> body_masses(const Mesh<dim> &mesh);

  /**
   * The kinetic energy that contact can still take from bodies that approach one another slowly:
   * what impulses along the present contact forces (without friction) take until they stop,
   *
   *   (F.v)^2 / (2 F.M^-1 F),   F.v = sum of F_b.v_b < 0,
   *
   * with the sum F_b of the contact forces, mean velocity v_b and mass of each body; rotations are
   * left out, and so are bodies that Dirichlet conditions hold. Zero if bodies separate, touch an
   * obstacle that moves, or are fast: at more than 1/300 of the speed of a wave the
   * contact of a ball becomes larger than a tenth of its radius (Hertz), and what its first touch
   * does to the ball comes back to it. Collective.
   * @param force the sum of the sizes of all normal contact forces
   */
  template <int dim>
  double energy_of_slow_approach(const Discretization<dim> &discretization,
                                 const ContactSurface<dim> &surface,
                                 const State               &state,
                                 const std::vector<double> &masses,
                                 double                     force);
} // namespace signorini

#endif
