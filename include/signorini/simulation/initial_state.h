// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_initial_state_h
#define signorini_simulation_initial_state_h

#include <signorini/discretization/discretization.h>
#include <signorini/time/state.h>

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
} // namespace signorini

#endif
