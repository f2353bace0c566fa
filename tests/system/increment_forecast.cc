// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The first guess of an increment is the combination of the last ones that is closest to the
// solution in the norm of K: what is left is orthogonal to all of them, and nothing is left if the
// solution is such a combination. Forces that hold constraints are extrapolated, those that grow
// linearly exactly. A step that is made again begins with its latest increment, whose residual is
// known, and leaves one increment behind, the last one.

#include <signorini/system/increment_forecast.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>

using namespace signorini;

namespace
{
  constexpr unsigned int n = 12;

  class Forecast : public testing::Test
  {
  protected:
    std::mt19937      random{7};
    Eigen::MatrixXd   K = make_matrix();
    IncrementForecast forecast;

    Eigen::VectorXd vector()
    {
      std::uniform_real_distribution<double> number(-1., 1.);
      return Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index) { return number(random); });
    }

    static Vector distributed(const Eigen::VectorXd &values)
    {
      Vector result(n);
      for (unsigned int i = 0; i < n; ++i)
        result.local_element(i) = values[i];
      return result;
    }

    static Eigen::VectorXd dense(const Vector &values)
    {
      return Eigen::Map<const Eigen::VectorXd>(values.begin(), n);
    }

    /** A solved step: K d + s = b. */
    void remember(const Eigen::VectorXd &d, const Eigen::VectorXd &s = Eigen::VectorXd::Zero(n))
    {
      forecast.remember(distributed(K * d + s), distributed(d), distributed(s));
    }

    Eigen::VectorXd guess(const Eigen::VectorXd &b)
    {
      Vector increment(n);
      EXPECT_TRUE(forecast.guess(distributed(b), increment));
      return dense(increment);
    }

  private:
    Eigen::MatrixXd make_matrix()
    {
      Eigen::MatrixXd half(n, n);
      for (unsigned int i = 0; i < n; ++i)
        half.col(i) = vector();
      return half * half.transpose() + Eigen::MatrixXd::Identity(n, n);
    }
  };
} // namespace


TEST_F(Forecast, KnowsNothingAtFirstAndAfterItHasForgotten)
{
  Vector increment(n);
  increment = 3.;
  EXPECT_FALSE(forecast.guess(distributed(vector()), increment));
  EXPECT_EQ(increment(0), 3.);
  remember(vector());
  forecast.clear();
  EXPECT_FALSE(forecast.guess(distributed(vector()), increment));
  EXPECT_EQ(increment(0), 3.);
}


TEST_F(Forecast, IsExactForCombinationsOfTheLastIncrements)
{
  const Eigen::VectorXd d = vector(), e = vector();
  remember(d);
  remember(e);
  EXPECT_LT((guess(K * (2. * d - 3. * e)) - (2. * d - 3. * e)).norm(), 1e-11);
}


TEST_F(Forecast, LeavesAnErrorThatIsOrthogonalToAllIncrements)
{
  std::vector<Eigen::VectorXd> kept;
  for (unsigned int k = 0; k < 4; ++k)
    {
      kept.push_back(vector());
      remember(kept.back());
    }
  const Eigen::VectorXd solution = vector(), error = solution - guess(K * solution);
  EXPECT_GT(error.norm(), 0.1);
  for (const Eigen::VectorXd &d : kept)
    EXPECT_NEAR(d.dot(K * error), 0., 1e-10 * d.norm() * (K * solution).norm());
}


TEST_F(Forecast, ExtrapolatesForcesOfConstraints)
{
  const Eigen::VectorXd d = vector(), first = vector(), growth = vector();
  remember(d, first);
  remember(d, first + growth);
  EXPECT_LT((guess(K * d + first + 2. * growth) - d).norm(), 1e-11);
}


TEST_F(Forecast, BearsIncrementsThatAreZeroOrAlike)
{
  const Eigen::VectorXd d = vector();
  remember(Eigen::VectorXd::Zero(n));
  EXPECT_EQ(guess(K * d).norm(), 0.);
  for (unsigned int k = 0; k < 10; ++k)
    remember((1. + 1e-15 * k) * d);
  EXPECT_LT((guess(K * d) - d).norm(), 1e-9);
}


TEST_F(Forecast, ForgetsAtASolutionThatIsFarTooLarge)
{
  // Its round-off would be larger than what comes after it.
  remember(vector());
  remember(1e7 * vector(), 1e9 * vector());
  Vector increment(n);
  EXPECT_FALSE(forecast.guess(distributed(vector()), increment));

  const Eigen::VectorXd d = vector();
  remember(d);
  EXPECT_LT((guess(K * d) - d).norm(), 1e-12 * d.norm());
  remember(Eigen::VectorXd::Zero(n)); // comes to rest
  EXPECT_FALSE(forecast.guess(distributed(vector()), increment));
}


TEST_F(Forecast, RepeatsTheLatestStepAndForgetsWhatItWas)
{
  const Eigen::VectorXd first = vector(), rough = vector(), solution = vector(), b = vector();
  Vector                increment(n), residual(n);
  EXPECT_FALSE(forecast.repeat(distributed(b), increment, residual));
  remember(first);
  remember(rough, vector());
  EXPECT_TRUE(forecast.repeat(distributed(b), increment, residual));
  EXPECT_EQ(dense(increment), rough);
  EXPECT_LT((dense(residual) - (b - K * rough)).norm(), 1e-12 * b.norm() * K.norm());
  remember(solution);

  // Combinations of the first and the last increment are exact, others are not.
  EXPECT_LT((guess(K * (first + 2. * solution)) - first - 2. * solution).norm(), 1e-10);
  EXPECT_GT((guess(K * rough) - rough).norm(), 0.1);
}
