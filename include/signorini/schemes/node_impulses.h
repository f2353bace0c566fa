// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_node_impulses_h
#define signorini_schemes_node_impulses_h

#include <signorini/time/dynamical_system.h>

namespace signorini
{
  /** Impulses I_p >= 0 of the contact nodes, force times time, in the order of NormalGap. */
  struct NodeImpulses
  {
    std::vector<double> impulses;
    unsigned int        iterations = 0;
    bool                converged  = false; ///< if not, the impulses are not to be used
  };

  /** The contact of one step as these equations see it: one number per contact node that this process owns. */
  struct NodeContact
  {
    const std::vector<double> &force;    ///< Lambda_p >= 0, compression; nodes without a force get no impulse
    const NormalGap           &gap;      ///< gamma_p at the start of the step, length
    const NormalGap           &approach; ///< w_p = [v*].nu at its end, velocity without impulses
  };

  /**
   * Impulses that give each contact node back what its force has taken from the energy: the coupled quadratic equations of Laursen and
   * Love (2002; Krause and Walloth 2012, section 3.2)
   *
   *   I_p (-w_p + 1/2 (G I)_p) = Lambda_p gamma_p,   G = B M^-1 B',
   *
   * with the normal velocities w = B v* and B' the nodal forces of normal ones. Of their many solutions the one with I >= 0 that pushes the
   * bodies apart is wanted. There is exactly one: the equations are the conditions for the minimum of the strictly convex
   *
   *   Phi(I) = 1/4 I'G I - w'I - sum_p Lambda_p gamma_p log I_p   over I >= 0,
   *
   * where nodes that have lost nothing contribute no logarithm: they reverse their approach or have no impulse.
   *
   * KINSOL of SUNDIALS finds it by a fixed point with Anderson acceleration. For D = diag(D_p) each node solves its own quadratic equation,
   *
   *   1/2 D_p I_p^2 - omega_p I_p = Lambda_p gamma_p,   omega_p = w_p - 1/2 (G I)_p + 1/2 D_p I_p,
   *
   * which for D >= G descends in Phi. D estimates the norms of the rows of G from its products with random signs; it decides about the
   * number of iterations, not about the result. Collective.
   */
  NodeImpulses solve_node_impulses(DynamicalSystem &system, const NodeContact &contact);
} // namespace signorini

#endif
