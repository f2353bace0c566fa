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

  /**
   * The contact of one step as these equations see it: one number per contact node that this
   * process owns.
   */
  struct NodeContact
  {
    const std::vector<double>
                    &force;    ///< Lambda_p >= 0, compression; nodes without a force get no impulse
    const NormalGap &gap;      ///< gamma_p at the start of the step, length
    const NormalGap &approach; ///< w_p = [v*].nu at its end, velocity without impulses
  };

  /**
   * Impulses that give each contact node back what its force has taken from the energy. They solve
   * the coupled quadratic equations of Laursen and Love (@cite laursen_love_2002;
   * @cite krause_walloth_2012, section 3.2)
   * @f[
   *   I_p (-w_p + \tfrac12 (G I)_p) = \Lambda_p \gamma_p, \quad G = B M^{-1} B^T,
   * @f]
   * with the normal velocities @f$w = B v^*@f$ and @f$B^T@f$ the nodal forces of normal ones. Of
   * their many solutions the one with @f$I \ge 0@f$ that pushes the bodies apart is wanted. There
   * is exactly one: the equations are the conditions for the minimum of the strictly convex
   * @f[
   *   \Phi(I) = \tfrac14 I^T G I - w^T I - \sum_p \Lambda_p \gamma_p \log I_p
   *   \quad \text{over} \quad I \ge 0,
   * @f]
   * where nodes that have lost nothing contribute no logarithm: they reverse their approach or have
   * no impulse.
   *
   * KINSOL of SUNDIALS finds it by a fixed point with Anderson acceleration. For
   * @f$D = \operatorname{diag}(D_p)@f$ each node solves its own quadratic equation,
   * @f[
   *   \tfrac12 D_p I_p^2 - \omega_p I_p = \Lambda_p \gamma_p,
   *   \quad \omega_p = w_p - \tfrac12 (G I)_p + \tfrac12 D_p I_p,
   * @f]
   * which for @f$D \ge G@f$ descends in @f$\Phi@f$. @f$D@f$ estimates the norms of the rows of
   * @f$G@f$ from its products with random signs; it decides about the number of iterations, not
   * about the result. Collective.
   */
  NodeImpulses solve_node_impulses(DynamicalSystem &system, const NodeContact &contact);
} // namespace signorini

#endif
