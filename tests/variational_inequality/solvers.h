// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_solvers_h
#define signorini_tests_solvers_h

// The solvers that the tests compare, by name, and one call that solves a dense problem with any of
// them.

#include <signorini/variational_inequality/primal_dual_active_set.h>
#include <signorini/variational_inequality/truncated_newton_multigrid.h>

#include "dense_problem.h"

#include <memory>
#include <string>

namespace signorini
{
  inline std::unique_ptr<ConstrainedSolver> make_active_set()
  {
    return std::make_unique<PrimalDualActiveSet>(ActiveSetLimits());
  }

  inline std::unique_ptr<ConstrainedSolver> make_mprgp()
  {
    return std::make_unique<Mprgp>();
  }

  inline std::unique_ptr<ConstrainedSolver> make_truncated_newton()
  {
    return std::make_unique<TruncatedNewtonMultigrid>(1000);
  }

  struct SolverCase
  {
    const char *solver;
    std::unique_ptr<ConstrainedSolver> (*make_solver)();
    const char *preconditioner; ///< exact | diagonal
  };

  const SolverCase solver_cases[] = {{"active_set", make_active_set, "exact"},
                                     {"active_set", make_active_set, "diagonal"},
                                     {"truncated_newton", make_truncated_newton, "exact"},
                                     {"truncated_newton", make_truncated_newton, "diagonal"},
                                     {"mprgp", make_mprgp, "diagonal"}};

  inline std::ostream &operator<<(std::ostream &out, const SolverCase &solver_case)
  {
    return out << solver_case.solver << "_" << solver_case.preconditioner;
  }

  struct Answer
  {
    SolveReport     report;
    ActiveSet       active;
    Eigen::VectorXd solution, residual;
  };

  inline Answer solve(ConstrainedSolver  &solver,
                      const SolverCase   &solver_case,
                      const DenseProblem &data,
                      const ActiveSet    &guess)
  {
    const bool          exact = std::string(solver_case.preconditioner) == "exact";
    const DenseOperator matrix(data.matrix);
    DenseInverse        preconditioner(exact ? data.matrix
                                      : Eigen::MatrixXd(data.matrix.diagonal().asDiagonal()));
    const Vector        right_hand_side = to_vector(data.right_hand_side);
    Vector              solution(data.matrix.rows()), residual(data.matrix.rows());
    Answer              answer;
    answer.active   = guess;
    answer.report   = solver.solve({matrix,
                                    preconditioner,
                                    right_hand_side,
                                    data.bounded_entries,
                                    data.upper_bounds,
                                    data.fixed_entries,
                                    data.fixed_values,
                                    1e-11,
                                    1e-12},
                                 answer.active,
                                 solution,
                                 residual);
    answer.solution = to_eigen(solution);
    answer.residual = to_eigen(residual);
    return answer;
  }

  inline Answer solve(const SolverCase &solver_case, const DenseProblem &data)
  {
    return solve(
      *solver_case.make_solver(), solver_case, data, ActiveSet(data.bounded_entries.size(), 0));
  }
} // namespace signorini

#endif
