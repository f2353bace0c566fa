// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The answer does not depend on the first guess, and bounds that are just reached (no multiplier)
// do not disturb: the solution of a strictly convex problem is unique.

#include <gtest/gtest.h>

#include "solvers.h"

using namespace signorini;

namespace
{
  /** A chain of springs, pushed up in the middle. */
  DenseProblem chain(const unsigned int n)
  {
    DenseProblem problem;
    problem.matrix = 2. * Eigen::MatrixXd::Identity(n, n);
    for (unsigned int i = 0; i + 1 < n; ++i)
      problem.matrix(i, i + 1) = problem.matrix(i + 1, i) = -1.;
    problem.right_hand_side        = Eigen::VectorXd::Zero(n);
    problem.right_hand_side[n / 2] = 1.;
    for (unsigned int i = 0; i < n; ++i)
      {
        problem.bounded_entries.push_back(i);
        problem.upper_bounds.push_back(1.);
      }
    return problem;
  }

  class AnyStart : public testing::TestWithParam<SolverCase>
  {
  };
} // namespace

TEST_P(AnyStart, EveryFirstGuessLeadsToTheSameAnswer)
{
  DenseProblem problem           = chain(7);
  problem.upper_bounds           = {infinity, 0.5, 0.6, 0.7, -0.2, 0.1, 0.1};
  const Eigen::VectorXd solution = brute_force(problem);
  const ActiveSet       active   = solve(GetParam(), problem).active;
  EXPECT_TRUE(active != ActiveSet(7, 0) && active != ActiveSet(7, 1));
  for (unsigned int set = 0; set < 128; ++set)
    {
      ActiveSet guess(7);
      for (unsigned int k = 0; k < 7; ++k)
        guess[k] = (set >> k) & 1;
      const auto   solver = GetParam().make_solver();
      const Answer answer = solve(*solver, GetParam(), problem, guess);
      EXPECT_LT((answer.solution - solution).norm(), 1e-10) << "guess " << set;
      EXPECT_EQ(answer.active, active) << "guess " << set;
    }
}

TEST_P(AnyStart, TheRightGuessCostsNoFurtherSet)
{
  DenseProblem problem = chain(7);
  problem.upper_bounds = {infinity, 0.5, 0.6, 0.7, -0.2, 0.1, 0.1};
  const Answer first   = solve(GetParam(), problem);
  const auto   solver  = GetParam().make_solver();
  const Answer again   = solve(*solver, GetParam(), problem, first.active);
  EXPECT_LE(again.report.active_set_iterations, first.report.active_set_iterations);
  if (std::string(GetParam().solver) == "active_set")
    {
      EXPECT_LE(again.report.active_set_iterations, 2u); // a rough solve and an accurate one
      EXPECT_FALSE(again.report.n_fallbacks);
    }
}

TEST_P(AnyStart, BoundsThatAreJustReached)
{
  DenseProblem          problem = chain(5);
  const Eigen::VectorXd free    = problem.matrix.inverse() * problem.right_hand_side;
  for (unsigned int k = 0; k < 5; ++k)
    problem.upper_bounds[k] = free[k];
  for (const char guess : {0, 1})
    {
      const auto   solver = GetParam().make_solver();
      const Answer answer = solve(*solver, GetParam(), problem, ActiveSet(5, guess));
      EXPECT_LT((answer.solution - free).norm(), 1e-10);
      EXPECT_LT(answer.residual.norm(), 1e-10);
      EXPECT_FALSE(answer.report.n_fallbacks);
    }
}

TEST_P(AnyStart, NothingBounded)
{
  DenseProblem          problem = chain(5);
  const Eigen::VectorXd free    = problem.matrix.inverse() * problem.right_hand_side;
  problem.bounded_entries.clear();
  problem.upper_bounds.clear();
  const Answer answer = solve(GetParam(), problem);
  EXPECT_LT((answer.solution - free).norm(), 1e-10);
  EXPECT_EQ(answer.report.n_active, 0u);
}

TEST_P(AnyStart, EverythingHeld)
{
  DenseProblem problem = chain(4);
  problem.upper_bounds = {-1., -2., -1., -2.};
  problem.right_hand_side.setConstant(10.);
  const Answer answer = solve(GetParam(), problem);
  EXPECT_EQ(answer.solution, (Eigen::Vector4d(-1., -2., -1., -2.)));
  EXPECT_EQ(answer.report.n_active, 4u);
  EXPECT_LT((answer.residual - Eigen::Vector4d(10., 12., 8., 13.)).norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All,
                         AnyStart,
                         testing::ValuesIn(solver_cases),
                         testing::PrintToStringParamName());
