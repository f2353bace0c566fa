// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_alpha_rule_h
#define signorini_schemes_alpha_rule_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * The balance of the generalized-alpha methods (@cite chung_hulbert_1993) and what follows from
   * it for the increment @f$d@f$. With accelerations @f$a@f$,
   * @f{align*}{
   *   M [(1 - \alpha_m) a_\text{new} + \alpha_m a] + A [(1 - \alpha_f) u_\text{new} + \alpha_f u]
   *     &= (1 - \alpha_f) f_\text{new} + \alpha_f f, \\
   *   d &= \tau v + \tau^2 [(\tfrac12 - \beta) a + \beta a_\text{new}], \\
   *   v_\text{new} &= v + \tau [(1 - \gamma) a + \gamma a_\text{new}], \\
   *   \beta &= \tfrac14 (1 - \alpha_m + \alpha_f)^2, \\
   *   \gamma &= \tfrac12 - \alpha_m + \alpha_f.
   * @f}
   */
  class AlphaRule
  {
  public:
    /** Spectral radius where nobody says another one. */
    static constexpr double usual_radius = 0.8;

    AlphaRule(double alpha_m, double alpha_f);

    /** The method of a spectral radius at infinite frequency, 0 <= rho <= 1. */
    static AlphaRule with_spectral_radius(double rho);

    const double alpha_m, alpha_f, beta, gamma;

    /** tau v + tau^2 (1/2 - beta) a: the increment without a_new. */
    Vector free_increment(const State &state, const Vector &acceleration, double step_size) const;

    /** tau [(1 - gamma) a + gamma a_new]. */
    Vector velocity_change(const Vector &acceleration,
                           const Vector &new_acceleration,
                           double        step_size) const;

    /** b of (M + s A) d = b, the balance multiplied by beta tau^2 / (1 - alpha_m). */
    Vector right_hand_side(DynamicalSystem &system,
                           const State     &state,
                           const Vector    &acceleration,
                           const Vector    &free_increment,
                           double           step_size) const;

    /** s. */
    double stiffness_factor(double step_size) const;

    /** From reactions K d - b to forces in the balance. */
    double reaction_weight(double step_size) const;

    /**
     * What the rule itself does to the energy: forces are not means of both ends, and the mean
     * velocity is not d/tau. The balance times d, with the differences @f$[\cdot]@f$ of both ends,
     * gives
     * @f[
     *   (\alpha_f - \tfrac12) (M [a] + A d - [f]) \cdot d
     *     - (\beta - \tfrac\gamma2) \tau [a] \cdot M [v].
     * @f]
     * It holds for any @f$a@f$ at the start, and with jumps of the velocity. One product with M.
     * @param acceleration a @param increment d
     */
    double work(DynamicalSystem &system,
                const State     &before,
                const State     &after,
                const Vector    &acceleration,
                const Vector    &increment) const;
  };
} // namespace signorini

#endif
