// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_trapezoidal_rule_h
#define signorini_schemes_trapezoidal_rule_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * The steps that most schemes share, Newmark's with @f$2 \beta = \gamma = \tfrac12@f$. With the
   * differences @f$[\cdot]@f$ of both ends, the increment @f$d = [u]@f$, the mean @f$\bar f@f$ of
   * the loads and the damping matrix @f$C@f$ of the bodies,
   * @f{align*}{
   *   M [v] &= \tau (\bar f - A (u + \tfrac12 d) - (C + b A) d/\tau
   *            + \text{forces of constraints}), \\
   *   d &= p + \tfrac\tau2 [v],
   * @f}
   * with @f$p@f$ the predictor of the increment, @f$\tau v@f$ or its projection. Hence
   * @f[
   *   (M + (\tfrac{\tau^2}4 + \tfrac{b \tau}2) A + \tfrac\tau2 C) d
   *     = M p - \tfrac{\tau^2}2 (A u - \bar f) + \tfrac{\tau^2}2 \text{(forces of constraints)}.
   * @f]
   * The scheme's own damping, @f$b = \tfrac\tau2 (1 - \rho)/(1 + \rho)@f$, takes energy from what
   * the step cannot resolve, @f$b/\tau \, d^T A d@f$ in each step, and never adds any:
   * displacements that are much faster than a step shrink by @f$\rho@f$ in each. @f$\rho = 1@f$:
   * none.
   */
  class TrapezoidalRule
  {
  public:
    /** @param spectral_radius rho, 0 <= rho <= 1 */
    explicit TrapezoidalRule(const double spectral_radius = 1.)
      : damping((1. - spectral_radius) / (2. * (1. + spectral_radius)))
    {
    }

    /** b/tau. */
    const double damping;

    /** tau M v - tau^2/2 (A u - mean load): the right-hand side for p = tau v. */
    Vector right_hand_side(DynamicalSystem &system, const State &state, double step_size) const;

    /** The factor of A, tau^2/4 + b tau/2. */
    double stiffness_factor(const double step_size) const
    {
      return step_size * step_size * (0.25 + 0.5 * damping);
    }

    /** Solve for the increment, d.nu <= bounds. @param further_reaction see IncrementProblem */
    IncrementSolution solve(DynamicalSystem &system,
                            const State     &state,
                            double           step_size,
                            const Vector    &right_hand_side,
                            const NormalGap &bounds,
                            const Vector    *further_reaction = nullptr) const;

    /** From reactions K d - b to forces in the balance, 2/tau^2. */
    double reaction_weight(const double step_size) const { return 2. / (step_size * step_size); }

    /** [v] = 2/tau (d - p). */
    Vector
    velocity_change(const Vector &increment, const Vector &predictor, double step_size) const;

    /** Of the reactions at prescribed components. */
    double dirichlet_work(const IncrementSolution &solution, double step_size) const;

    /** What both kinds of damping do to the energy in a step, into the works of the report. */
    void book_dissipation(DynamicalSystem &system,
                          const State     &before,
                          const State     &after,
                          const Vector    &increment,
                          StepReport      &report) const;

    /** A step whose predictor is tau v and whose only contact force is that of the solution. */
    TakenStep finish_implicit(DynamicalSystem         &system,
                              const State             &start,
                              double                   step_size,
                              const IncrementSolution &solution) const;
  };

  /**
   * The spectral radius of schemes that damp what the step cannot resolve, where the scene does not
   * say it: 1 up to Courant number 40, 0.6 from 80 on, between them by the logarithm. The reasons
   * and measurements are in doc/schemes.md.
   * @param courant_number of the smallest cells
   */
  double automatic_spectral_radius(double courant_number);
} // namespace signorini

#endif
