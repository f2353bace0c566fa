// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_constrained_solver_h
#define signorini_variational_inequality_constrained_solver_h

#include <signorini/base/solve_report.h>
#include <signorini/variational_inequality/constrained_problem.h>

namespace signorini
{
  /** Asserts that the parts of a problem belong together, as do its unknowns. */
  void check_sizes(const ConstrainedProblem &problem,
                   const ActiveSet          &active,
                   const Vector             &solution,
                   const Vector             &residual);

  /** Solves a ConstrainedProblem to its tolerance or throws; never returns an unconverged answer.
   */
  class ConstrainedSolver
  {
  public:
    virtual ~ConstrainedSolver() = default;

    /**
     * @param active   on entry a guess (one per bounded entry), on exit the entries held at their
     *                 bound
     * @param solution on entry a guess, on exit the solution
     * @param residual on exit b - K x in all entries: the multipliers in the active ones
     * @throws RunError if the method fails
     */
    virtual SolveReport solve(const ConstrainedProblem &problem,
                              ActiveSet                &active,
                              Vector                   &solution,
                              Vector                   &residual) = 0;
  };
} // namespace signorini

#endif
