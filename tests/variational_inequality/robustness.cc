// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A problem on which the plain active set method runs in circles (found by random search) ends in
// the guaranteed method with the right answer; a problem that has no answer ends in a RunError,
// never in a wrong solution.

#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

#include <set>

#include "solvers.h"

using namespace signorini;

namespace
{
  DenseProblem cycling_problem()
  {
    DenseProblem problem;
    problem.matrix.resize(5, 5);
    problem.matrix << 22, 2, -4, -14, -2, //
      2, 23, -8, -19, -8,                 //
      -4, -8, 20, 22, -10,                //
      -14, -19, 22, 36, -4,               //
      -2, -8, -10, -4, 28;
    problem.right_hand_side.resize(5);
    problem.right_hand_side << 0, 4, 0, -3, -2;
    problem.bounded_entries = {0, 1, 2, 3, 4};
    problem.upper_bounds.assign(5, 0.);
    return problem;
  }

  DenseProblem small_problem()
  {
    DenseProblem problem;
    problem.matrix.resize(2, 2);
    problem.matrix << 2., -1., -1., 2.;
    problem.right_hand_side.resize(2);
    problem.right_hand_side << 1., 3.;
    problem.bounded_entries = {0};
    problem.upper_bounds    = {0.5};
    return problem;
  }

  class Robustness : public testing::TestWithParam<SolverCase>
  {
  };
} // namespace

TEST(Cycle, ThePlainMethodNeverEnds)
{
  const DenseProblem  problem = cycling_problem();
  ActiveSet           active(5, 0);
  std::set<ActiveSet> seen;
  while (seen.insert(active).second)
    {
      const Eigen::VectorXd x = solve_with(problem, active),
                            s = problem.right_hand_side - problem.matrix * x;
      const ActiveSet before  = active;
      for (unsigned int i = 0; i < 5; ++i)
        active[i] = active[i] ? s[i] >= 0. : x[i] > 1e-12;
      ASSERT_NE(active, before);
    }
}

TEST(Cycle, EndsInTheGuaranteedMethod)
{
  const DenseProblem problem = cycling_problem();
  const Answer       answer  = solve(solver_cases[0], problem);
  EXPECT_TRUE(answer.report.n_fallbacks);
  EXPECT_LT((answer.solution - brute_force(problem)).norm(), 1e-9);
}

TEST_P(Robustness, ACycleOfThePlainMethod)
{
  const DenseProblem problem = cycling_problem();
  EXPECT_LT((solve(GetParam(), problem).solution - brute_force(problem)).norm(), 1e-9);
}

TEST_P(Robustness, NoAnswerIsAnError)
{
  EXPECT_NO_THROW(solve(GetParam(), small_problem()));
  DenseProblem problem       = small_problem();
  problem.right_hand_side[1] = std::nan("");
  EXPECT_THROW(solve(GetParam(), problem), RunError);
}

TEST(Failure, TooFewIterationsAreAnError)
{
  Mprgp solver(1);
  EXPECT_THROW(solve(solver, solver_cases[2], cycling_problem(), ActiveSet(5, 0)), RunError);
}

TEST(Failure, ALinearSolverThatGivesUpDoesNotEndTheSearch)
{
  ActiveSetLimits limits;
  limits.maximum_linear_iterations = 1;
  PrimalDualActiveSet solver(limits);
  const DenseProblem  problem = cycling_problem();
  const Answer        answer  = solve(solver, solver_cases[1], problem, ActiveSet(5, 0));
  EXPECT_TRUE(answer.report.n_fallbacks);
  EXPECT_LT((answer.solution - brute_force(problem)).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All,
                         Robustness,
                         testing::ValuesIn(solver_cases),
                         testing::PrintToStringParamName());
