// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Every solver finds the minimiser that trying all active sets finds, whatever the matrix, and its
// answer satisfies the conditions of optimality: bounds, non-negative multipliers, complementarity,
// equations in the free entries.

#include <gtest/gtest.h>

#include "solvers.h"

using namespace signorini;

namespace
{
  using Generator = std::mt19937;

  Eigen::MatrixXd random_matrix(const unsigned int n, Generator &generator)
  {
    std::normal_distribution<double> number;
    return Eigen::MatrixXd::NullaryExpr(n, n, [&] { return number(generator); });
  }

  Eigen::MatrixXd with_eigenvalues(const Eigen::VectorXd &eigenvalues, Generator &generator)
  {
    const Eigen::MatrixXd basis =
      random_matrix(eigenvalues.size(), generator).householderQr().householderQ();
    return basis * eigenvalues.asDiagonal() * basis.transpose();
  }

  /**
   * Non-positive off-diagonal entries, strictly diagonally dominant: the active set method is
   * monotone.
   */
  Eigen::MatrixXd m_matrix(const unsigned int n, Generator &generator)
  {
    Eigen::MatrixXd matrix = -random_matrix(n, generator).cwiseAbs();
    matrix                 = (matrix + matrix.transpose()).eval();
    matrix.diagonal().setZero();
    matrix.diagonal() = (0.1 - matrix.rowwise().sum().array()).matrix();
    return matrix;
  }

  class AllSolvers : public testing::TestWithParam<SolverCase>
  {
  protected:
    void compare(const DenseProblem &problem, const double accuracy) const
    {
      const Answer           answer = solve(GetParam(), problem);
      const Eigen::VectorXd &x = answer.solution, &s = answer.residual;
      EXPECT_LT((x - brute_force(problem)).norm(), accuracy);
      EXPECT_LT((s - problem.right_hand_side + problem.matrix * x).norm(), accuracy);
      Eigen::VectorXd equations = s;
      unsigned int    n_active  = 0;
      for (unsigned int k = 0; k < problem.bounded_entries.size(); ++k)
        {
          const unsigned int i = problem.bounded_entries[k];
          EXPECT_LE(x[i], problem.upper_bounds[k] + 1e-12);
          if (answer.active[k])
            {
              ++n_active;
              EXPECT_EQ(x[i], problem.upper_bounds[k]);
              EXPECT_GE(s[i], -accuracy);
              equations[i] = 0.;
            }
        }
      EXPECT_EQ(answer.report.n_active, n_active);
      for (unsigned int j = 0; j < problem.fixed_entries.size(); ++j)
        {
          EXPECT_EQ(x[problem.fixed_entries[j]], problem.fixed_values[j]);
          equations[problem.fixed_entries[j]] = 0.;
        }
      EXPECT_LT(equations.norm(), accuracy);
    }
  };
} // namespace

TEST_P(AllSolvers, MMatrices)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
    {
      Generator generator(seed);
      compare(random_problem(m_matrix(5 + seed % 4, generator), generator), 1e-9);
    }
}

TEST_P(AllSolvers, MatricesWithAnySigns)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
    {
      Generator             generator(seed);
      const unsigned int    n        = 5 + seed % 4;
      const Eigen::VectorXd spectrum = Eigen::VectorXd::LinSpaced(n, 0.2, 5.);
      compare(random_problem(with_eigenvalues(spectrum, generator), generator), 1e-9);
    }
}

TEST_P(AllSolvers, BadCondition)
{
  for (unsigned int seed = 1; seed <= 10; ++seed)
    {
      Generator             generator(seed);
      const Eigen::VectorXd exponents = Eigen::VectorXd::LinSpaced(6, -4., 2.);
      const Eigen::VectorXd spectrum =
        exponents.unaryExpr([](const double e) { return std::pow(10., e); });
      compare(random_problem(with_eigenvalues(spectrum, generator), generator), 1e-7);
    }
}

INSTANTIATE_TEST_SUITE_P(All,
                         AllSolvers,
                         testing::ValuesIn(solver_cases),
                         testing::PrintToStringParamName());
