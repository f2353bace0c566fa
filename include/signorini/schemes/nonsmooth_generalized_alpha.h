// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_nonsmooth_generalized_alpha_h
#define signorini_schemes_nonsmooth_generalized_alpha_h

#include <signorini/schemes/alpha_rule.h>

namespace signorini
{
  /**
   * Nonsmooth generalized-alpha method with restitution 0 (Chen, Acary, Virlez and Bruels 2013): loads and elastic forces by the
   * generalized-alpha rule, contact as jumps W of the velocity,
   *
   *   M [(1 - alpha_m) a_new + alpha_m a] + A [(1 - alpha_f) u_new + alpha_f u] = (1 - alpha_f) f_new + alpha_f f,   M W = P,
   *   u_new = u + tau v + tau^2 [(1/2 - beta) a + beta a_new] + tau/2 W,   v_new = v + tau [(1 - gamma) a + gamma a_new] + W.
   *
   * The impulses P of contact, P.nu <= 0, act on nodes that would penetrate in the middle of the step, gap - tau/2 v.nu <= 0, and keep them
   * from approaching at its end: v_new.nu <= 0, or P.nu = 0. With d = u_new - u this is, see AlphaRule,
   *
   *   (M + s A) d = b + tau/2 P,   d.nu <= [d_free - beta tau/gamma (v + tau (1 - gamma) a + epsilon W)].nu,   epsilon = 1 - gamma/(2 beta),
   *
   * a problem of increments whose bound depends a little on its solution: 0 <= epsilon <= 1/4 is zero for spectral radius 1, where the method is
   * that of Moreau and Jean. It is solved with the bound of the
   * last W until W does not change, with Anderson acceleration (FixedPoint).
   *
   * Order two without contact, damping of high frequencies by choice, penetration up to tau times the speed of approach, which is never
   * corrected. The state's contact force is P / tau.
   */
  class NonsmoothGeneralizedAlpha : public TimeScheme
  {
  public:
    explicit NonsmoothGeneralizedAlpha(const AlphaRule &rule)
      : rule(rule)
      , epsilon(1. - rule.gamma / (2. * rule.beta))
    {
    }

    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;

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
