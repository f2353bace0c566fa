// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_start_equilibrium_h
#define signorini_system_start_equilibrium_h

#include <signorini/system/static_equilibrium.h>
#include <signorini/time/state.h>

namespace signorini
{
  /** How a run started in equilibrium. */
  struct StartReport
  {
    unsigned int             n_products = 0; ///< with A
    std::string              unheld; ///< what is not held and begins to move, in words; or empty
    std::vector<std::string> remarks = {}; ///< what may not be as it was meant
  };

  /**
   * The equilibrium of a scene under its loads and contact at time 0 (StaticEquilibrium). Motions
   * that nothing holds are free: a block that slides on a plane starts with the shear that
   * decelerates it, a body in free fall without deformation. The slip of friction is the relative
   * tangential displacement from the undeformed bodies or, where the initial velocity relative to
   * the other body or obstacle has one, along its tangential part. Collective.
   * @param load         or null
   * @param of_obstacles velocities of what contact nodes face, zero elsewhere; or null
   * @param state        displacement, contact force and friction become those of the equilibrium;
   *                     the velocity is only read
   * @throws RunError if no equilibrium is found
   */
  template <int dim>
  StartReport start_in_equilibrium(const Discretization<dim>     &discretization,
                                   const ContactSurface<dim>     &surface,
                                   const ContactCoordinates<dim> &coordinates,
                                   const SolverParameters        &parameters,
                                   const Vector                  *load,
                                   const Vector                  *of_obstacles,
                                   State                         &state);
} // namespace signorini

#endif
