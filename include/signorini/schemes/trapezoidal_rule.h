// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_trapezoidal_rule_h
#define signorini_schemes_trapezoidal_rule_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * The steps that all schemes with @f$2 \beta = \gamma = \tfrac12@f$ share. The elastic forces of
   * both ends of the step act with equal weights, so that the increment @f$d@f$ solves
   * @f[
   *   (M + \tfrac{\tau^2}4 A) d = M p - \tfrac{\tau^2}2 (A u - f)
   *                               + \tfrac{\tau^2}2 \text{(forces of constraints)},
   * @f]
   * with @f$p@f$ the predictor of the increment.
   */
  namespace trapezoidal_rule
  {
    /** tau M v - tau^2/2 (A u - mean load): the right-hand side for p = tau v. */
    Vector right_hand_side(DynamicalSystem &system, const State &state, double step_size);

    /** The free increment tau v and its L2 projection onto the admissible ones. */
    struct ProjectedPredictor
    {
      Vector      increment;       ///< p = tau v + c
      Vector      correction;      ///< c
      Vector      mass_correction; ///< M c
      SolveReport effort;
    };
    ProjectedPredictor project_predictor(DynamicalSystem &system,
                                         const State     &state,
                                         double           step_size,
                                         const NormalGap &gap);

    /** Solve for the increment, d.nu <= gap. @param further_reaction see IncrementProblem */
    IncrementSolution solve(DynamicalSystem &system,
                            const State     &state,
                            double           step_size,
                            const Vector    &right_hand_side,
                            const NormalGap &gap,
                            const Vector    *further_reaction = nullptr);

    /** 2/tau^2 times the reaction at prescribed components times the increment. */
    double dirichlet_work(const IncrementSolution &solution, double step_size);

    /** A step without predictor: v_new = v + 2/tau (d - tau v), force 2/tau^2 times the reaction.
     */
    StepReport finish_implicit(DynamicalSystem         &system,
                               State                   &state,
                               double                   step_size,
                               const IncrementSolution &solution);

    /**
     * The complete state at the end of a step, u + d and v + velocity_change with the products M v
     * and A u. The state at its start is not touched: schemes swap both when nothing can fail any
     * more.
     */
    State end_of_step(const DynamicalSystem &system,
                      const State           &start,
                      double                 step_size,
                      const Vector          &increment,
                      const Vector          &velocity_change,
                      Vector               &&contact_force,
                      FrictionState        &&friction = {});
  } // namespace trapezoidal_rule
} // namespace signorini

#endif
