// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_initial_state_h
#define signorini_simulation_initial_state_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/time/state.h>

#include <string>
#include <vector>

namespace signorini
{
  /**
   * For tests only: initial velocities are larger by this part of themselves, the environment
   * variable SIGNORINI_PERTURB. What 1e-12 changes beyond that order is decided by round-off.
   */
  double perturbation_of_velocities();

  /**
   * The initial displacements and velocities of the bodies, without any force. Momentum and
   * internal force are still zero. Collective.
   */
  template <int dim>
  State initial_state(const Discretization<dim> &discretization);

  /** Sentences for the user. */
  struct Remarks
  {
    std::vector<std::string> notes, warnings;
  };

  /**
   * Prescribed nodes start with the velocity of their condition, whatever the body's initial
   * velocity is: schemes that take the velocity from displacements, v_new = 2 d/tau - v, would
   * otherwise alternate about it for ever. Collective.
   * @param step_size the first one; the derivative at time 0 is taken in a small part of it
   * @return what has been changed
   */
  template <int dim>
  Remarks start_with_conditions(const Discretization<dim>     &discretization,
                                const ContactCoordinates<dim> &coordinates,
                                double                         step_size,
                                Vector                        &velocity);

  /** Whether prescribed nodes are not where their conditions want them at time 0. Collective. */
  template <int dim>
  Remarks jump_to_conditions(const Discretization<dim>     &discretization,
                             const ContactCoordinates<dim> &coordinates,
                             const Vector                  &displacement);
} // namespace signorini

#endif
