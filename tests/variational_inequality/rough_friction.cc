// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Trials of a step are rough solutions, each of which goes on where the last one ended. With
// friction, too, they lead to the solution. Nodes that are nearly free of friction are the hard
// ones: an error of a trial may be larger than what they bear. If it decided anew whether they
// slip, each trial would repeat what the last one did, and win nothing.

#include <signorini/variational_inequality/frictional_newton.h>

#include "frictional_problem.h"

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  /** What is left of the error after a number of trials. */
  double error_after(const unsigned int n_trials, const FrictionalProblem &data)
  {
    FrictionalNewton solver{ActiveSetLimits()};
    const auto       run_trials =
      [&](const ConstrainedProblem &problem, ActiveSet &status, Vector &x, Vector &residual) {
        ConstrainedProblem trial = problem;
        trial.is_rough           = true;
        SolveReport report;
        for (unsigned int n = 0; n < n_trials; ++n)
          {
            report          = solver.solve(trial, status, x, residual);
            trial.continues = true;
          }
        return report;
      };
    const auto trials =
      solve_with(run_trials, data, Eigen::VectorXd::Zero(data.matrix.rows()), false);
    return (trials.solution - solve(solver, data).solution).norm();
  }
} // namespace


TEST(RoughFriction, LeadsToTheSolution)
{
  for (unsigned int seed = 0; seed < 100; ++seed)
    for (const unsigned int n_tangents : {1, 2})
      {
        const auto problem = random_frictional(6, n_tangents, FrictionLaw{0.4, 1e-6}, seed);
        EXPECT_LT(error_after(6, problem), 1e-6) << "seed " << seed << ", tangents " << n_tangents;
      }
}
