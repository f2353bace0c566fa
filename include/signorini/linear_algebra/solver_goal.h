// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_solver_goal_h
#define signorini_linear_algebra_solver_goal_h

#include <signorini/linear_algebra/improved_guess.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace signorini
{
  /** When a linear solver stops, see ConjugateGradients::solve(). */
  struct SolverLimits
  {
    double       tolerance;
    double       reduction;
    unsigned int maximum_iterations;
    bool         is_guess;
  };

  /** What is asked for, given the norm of the residual at the start. */
  using LimitsFor = std::function<SolverLimits(double norm)>;

  /** The norms of the residual that follow, once that at the start is known. */
  struct SolverGoal
  {
    SolverGoal(const double norm, const SolverLimits &limits)
      : improves_guess(limits.is_guess && norm <= limits.tolerance)
      , is_final(limits.reduction == 0. && !improves_guess)
      , accepted(std::max(limits.tolerance, limits.reduction * norm))
      , sought(improves_guess ? improved_guess(norm, limits.tolerance) : accepted)
    {
    }

    const bool   improves_guess;
    const bool   is_final; ///< what it leaves is the error of the step
    const double accepted;
    const double sought;

    /**
     * By how much the norm of the residual must be smaller than what is sought, once it is known
     * that P^-1 K has the eigenvalue lambda: the square of the error in the norm of K is up to
     * 1/lambda times that of the residual in that of P^-1.
     */
    double trust(const double lambda) const
    {
      constexpr double far_from_one = 0.1; // the norm of P is no longer that of K
      return is_final && lambda > 0. ? std::min(1., std::sqrt(lambda / far_from_one))
                                     : 1.; // 0 by round-off
    }
  };
} // namespace signorini

#endif
