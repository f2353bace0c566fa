// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_frictional_problem_h
#define signorini_tests_frictional_problem_h

// Dense problems with friction, and one call that solves them.

#include <signorini/variational_inequality/constrained_solver.h>
#include <signorini/variational_inequality/slip_system.h>

#include "dense_problem.h"

namespace signorini
{
  /** n nodes with one normal and n_tangents tangential entries each, then two free entries. */
  struct FrictionalProblem : DenseProblem
  {
    Friction friction;
  };

  inline FrictionalProblem random_frictional(const unsigned int n,
                                             const unsigned int n_tangents,
                                             const FrictionLaw &law,
                                             const unsigned int seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> number(-1., 1.);
    const unsigned int                     size = n * (1 + n_tangents) + 2;
    const Eigen::MatrixXd                  B =
      Eigen::MatrixXd::NullaryExpr(size, size, [&] { return number(generator); });
    FrictionalProblem problem;
    // As in a time step: a mass and some coupling.
    problem.matrix = Eigen::MatrixXd::Identity(size, size) + 0.6 / size * B * B.transpose();
    problem.right_hand_side =
      1.2 * Eigen::VectorXd::NullaryExpr(size, [&] { return number(generator); });
    for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int first = k * (1 + n_tangents);
        problem.right_hand_side[first] += 1.;
        problem.bounded_entries.push_back(first);
        problem.upper_bounds.push_back(0.3 * number(generator));
        FrictionNode node{{}, law};
        for (unsigned int j = 0; j < n_tangents; ++j)
          node.entries.push_back(first + 1 + j);
        problem.friction.push_back(node);
      }
    return problem;
  }

  struct FrictionalAnswer
  {
    SolveReport     report;
    ActiveSet       status;
    Eigen::VectorXd solution, residual;
  };

  /** Calls `minimise(problem, status, x, residual)`, a SolveReport, from a guess and open nodes. */
  template <class Minimise>
  FrictionalAnswer solve_with(const Minimise          &minimise,
                              const FrictionalProblem &data,
                              const Eigen::VectorXd   &guess,
                              const bool               exact)
  {
    const DenseOperator   matrix(data.matrix);
    const Eigen::MatrixXd diagonal = data.matrix.diagonal().asDiagonal();
    DenseInverse          preconditioner(exact ? data.matrix : diagonal);
    const Vector          right_hand_side = to_vector(data.right_hand_side);
    Vector                x               = to_vector(guess), residual(x);
    FrictionalAnswer      answer;
    answer.status.assign(data.bounded_entries.size(), contact_status::open);
    const ConstrainedProblem problem{matrix,
                                     preconditioner,
                                     right_hand_side,
                                     data.bounded_entries,
                                     data.upper_bounds,
                                     data.fixed_entries,
                                     data.fixed_values,
                                     1e-12,
                                     1e-13,
                                     data.friction};
    answer.report   = minimise(problem, answer.status, x, residual);
    answer.solution = to_eigen(x);
    answer.residual = to_eigen(residual);
    return answer;
  }

  inline FrictionalAnswer
  solve(ConstrainedSolver &solver, const FrictionalProblem &data, const bool exact = true)
  {
    return solve_with(
      [&](const ConstrainedProblem &problem, ActiveSet &status, Vector &x, Vector &residual) {
        return solver.solve(problem, status, x, residual);
      },
      data,
      Eigen::VectorXd::Zero(data.matrix.rows()),
      exact);
  }

  inline NodeForces
  forces_at(const FrictionalProblem &problem, const FrictionalAnswer &answer, const unsigned int k)
  {
    return node_forces(problem.friction[k],
                       problem.bounded_entries[k],
                       contact_status::is_closed(answer.status[k]),
                       to_vector(answer.solution),
                       to_vector(answer.residual));
  }
} // namespace signorini

#endif
