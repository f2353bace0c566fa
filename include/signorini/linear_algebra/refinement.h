// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_refinement_h
#define signorini_linear_algebra_refinement_h

#include <signorini/linear_algebra/linear_operator.h>
#include <signorini/linear_algebra/linear_report.h>
#include <signorini/linear_algebra/solver_goal.h>

namespace signorini
{
  class RoughSolver;

  /**
   * Iterative refinement: a RoughSolver finds corrections in single precision, and residuals in
   * double precision say what is left.
   */
  class Refinement
  {
  public:
    /**
     * @param matrix   what the rough solver solves with
     * @param solution on entry a guess, on exit the solution
     * @param residual b - K x of all entries, on entry and on exit
     * With a reduction, the last correction is not looked at: what follows does.
     */
    LinearReport solve(const RoughSolver    &rough_solver,
                       const LinearOperator &matrix,
                       Vector               &solution,
                       Vector               &residual,
                       const LimitsFor      &limits_for);

    /** The norm of the residual at the start of the last solve. */
    double initial_norm() const { return norm_at_start; }

  private:
    double norm_at_start = 0.;
    Vector correction, product;
  };
} // namespace signorini

#endif
