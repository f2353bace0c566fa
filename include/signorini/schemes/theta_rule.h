// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_theta_rule_h
#define signorini_schemes_theta_rule_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * The steps that most schemes share. With the differences @f$[\cdot]@f$ of both ends, the
   * increment @f$d = [u]@f$ and the damping matrix @f$C@f$,
   * @f{align*}{
   *   M [v] &= \tau (f_\theta - A (u + \theta d) - C d/\tau + \text{forces of constraints}), \\
   *   d &= p + \theta \tau [v],
   * @f}
   * with @f$p@f$ the predictor of the increment, @f$\tau v@f$ or its projection, and
   * @f$f_\theta = (1 - \theta) f + \theta f_\text{new}@f$. Hence
   * @f[
   *   (M + \theta^2 \tau^2 A + \theta \tau C) d
   *     = M p - \theta \tau^2 (A u - f_\theta) + \theta \tau^2 \text{(forces of constraints)}.
   * @f]
   * @f$\theta = \tfrac12@f$ is the trapezoidal rule, Newmark's with @f$2 \beta = \gamma =
   * \tfrac12@f$. A larger one takes energy from what the step cannot resolve: by @f$(\theta -
   * \tfrac12) ([v]^T M [v] + d^T A d)@f$ in each step, and never adds any.
   */
  class ThetaRule
  {
  public:
    explicit ThetaRule(const double theta = 0.5)
      : theta(theta)
    {
    }

    /**
     * theta = 1/(1 + rho): amplitudes of motions that are much faster than a step shrink by rho in
     * each, 0 <= rho <= 1.
     */
    static ThetaRule with_spectral_radius(const double rho) { return ThetaRule(1. / (1. + rho)); }

    const double theta;

    /** tau M v - theta tau^2 (A u - f_theta): the right-hand side for p = tau v. */
    Vector right_hand_side(DynamicalSystem &system, const State &state, double step_size) const;

    /** Solve for the increment, d.nu <= bounds. @param further_reaction see IncrementProblem */
    IncrementSolution solve(DynamicalSystem &system,
                            const State     &state,
                            double           step_size,
                            const Vector    &right_hand_side,
                            const NormalGap &bounds,
                            const Vector    *further_reaction = nullptr) const;

    /** From reactions K d - b to forces in the balance, 1/(theta tau^2). */
    double reaction_weight(const double step_size) const
    {
      return 1. / (theta * step_size * step_size);
    }

    /** [v] = (d - p)/(theta tau). */
    Vector
    velocity_change(const Vector &increment, const Vector &predictor, double step_size) const;

    /** Of the reactions at prescribed components. */
    double dirichlet_work(const IncrementSolution &solution, double step_size) const;

    /**
     * What the rule and damping do to the energy in a step, into `work_scheme` and `work_damping`.
     * @param velocity_change [v] of the rule
     */
    void book_dissipation(DynamicalSystem &system,
                          const State     &before,
                          const State     &after,
                          const Vector    &increment,
                          const Vector    &velocity_change,
                          StepReport      &report) const;

    /** A step whose predictor is tau v and whose only contact force is that of the solution. */
    StepReport finish_implicit(DynamicalSystem         &system,
                               State                   &state,
                               double                   step_size,
                               const IncrementSolution &solution) const;
  };
} // namespace signorini

#endif
