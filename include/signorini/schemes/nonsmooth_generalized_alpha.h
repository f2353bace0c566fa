// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_nonsmooth_generalized_alpha_h
#define signorini_schemes_nonsmooth_generalized_alpha_h

#include <signorini/schemes/alpha_rule.h>

namespace signorini
{
  /**
   * Nonsmooth generalized-alpha method with restitution 0 (@cite chen_acary_virlez_bruels_2013).
   * Loads and elastic forces by the generalized-alpha rule, contact as jumps @f$W@f$ of the
   * velocity,
   * @f{align*}{
   *   M [(1 - \alpha_m) a_\text{new} + \alpha_m a] + A [(1 - \alpha_f) u_\text{new} + \alpha_f u]
   *     &= (1 - \alpha_f) f_\text{new} + \alpha_f f, \\
   *   M W &= P, \\
   *   u_\text{new} &= u + \tau v + \tau^2 [(\tfrac12 - \beta) a + \beta a_\text{new}]
   *                   + \tfrac\tau2 W, \\
   *   v_\text{new} &= v + \tau [(1 - \gamma) a + \gamma a_\text{new}] + W.
   * @f}
   *
   * The impulses @f$P@f$ of contact, @f$P \cdot \nu \le 0@f$, act on nodes that would penetrate in
   * the middle of the step, @f$\mathrm{gap} - \tfrac\tau2 v \cdot \nu \le 0@f$, and keep them from
   * approaching at its end: @f$v_\text{new} \cdot \nu \le 0@f$, or @f$P \cdot \nu = 0@f$. With
   * @f$d = u_\text{new} - u@f$ this is, see AlphaRule,
   * @f{align*}{
   *   (M + s A) d &= b + \tfrac\tau2 P, \\
   *   d \cdot \nu &\le [d_\text{free}
   *     - \beta \tfrac\tau\gamma (v + \tau (1 - \gamma) a + \varepsilon W)] \cdot \nu,
   *     \quad \varepsilon = 1 - \tfrac{\gamma}{2 \beta},
   * @f}
   * a problem of increments whose bound depends a little on its solution:
   * @f$0 \le \varepsilon \le \tfrac14@f$ is zero for spectral radius 1, where the method is that of
   * Moreau and Jean. It is solved with the bound of the last @f$W@f$ until @f$W@f$ does not change,
   * with Anderson acceleration (FixedPoint).
   *
   * Order two without contact, damping of high frequencies by choice, penetration up to @f$\tau@f$
   * times the speed of approach, which is never corrected. The state's contact force is
   * @f$P / \tau@f$.
   */
  class NonsmoothGeneralizedAlpha : public TimeScheme
  {
  public:
    explicit NonsmoothGeneralizedAlpha(const AlphaRule &rule)
      : rule(rule)
      , epsilon(1. - rule.gamma / (2. * rule.beta))
    {
    }

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

  private:
    const AlphaRule rule;
    const double    epsilon;

    /** Solve for the increment; `jump` becomes W. */
    IncrementSolution solve(DynamicalSystem &system,
                            const State     &state,
                            double           tau,
                            const Vector    &right_hand_side,
                            const Vector    &bound_without_jump,
                            Vector          &jump) const;
  };
} // namespace signorini

#endif
