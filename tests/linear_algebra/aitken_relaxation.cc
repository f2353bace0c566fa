// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A fixed point that converges slowly along one direction converges at once when that is
// extrapolated, x + (g(x) - x) / (1 - rate); one with two rates much faster than without; and one
// that runs away is not made to run backwards.

#include <signorini/linear_algebra/aitken_relaxation.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  Eigen::VectorXd vector(const double x, const double y)
  {
    Eigen::VectorXd result(2);
    result << x, y;
    return result;
  }

  /** Errors of x <- diag(rates) x from (1, 1). @return |x| after some steps */
  double error_after(const unsigned int n_steps, const Eigen::Vector2d &rates)
  {
    AitkenRelaxation relaxation;
    Eigen::VectorXd  x = vector(1., 1.);
    for (unsigned int n = 0; n < n_steps; ++n)
      {
        const Eigen::VectorXd step = rates.asDiagonal() * x - x;
        x += relaxation.factor(step) * step;
      }
    return x.norm();
  }
} // namespace


TEST(AitkenRelaxation, OneRateIsExtrapolated)
{
  EXPECT_LT(error_after(2, {0.9, 0.9}), 1e-14);
}


TEST(AitkenRelaxation, TwoRates)
{
  // 0.9^12 = 0.28 without.
  EXPECT_LT(error_after(12, {0.9, 0.5}), 1e-4);
}


TEST(AitkenRelaxation, NoStepBackwards)
{
  AitkenRelaxation      relaxation;
  const Eigen::VectorXd step = vector(1., 0.);
  EXPECT_EQ(relaxation.factor(step), 1.);
  EXPECT_EQ(relaxation.factor(1.5 * step), 1.);
  relaxation.forget();
  EXPECT_EQ(relaxation.factor(0.5 * step), 1.);
}
