// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Fixed points of contractions, accelerated: the function is only ever asked for numbers, however
// dependent the differences are that acceleration combines, and the solution is exact to the limit.
// Where nothing can be found, the best image is kept and the iteration ends.

#include <signorini/schemes/fixed_point.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;

namespace
{
  constexpr FixedPoint::Limits limits{1e-10, 1e-8, 200};

  /** y_k = 1 + rate^(k + 1) y_k, counted; all differences lie in the span of n_rates vectors. */
  double contraction(const unsigned int n_rates, const Vector &current, Vector &image)
  {
    EXPECT_TRUE(std::isfinite(current.l1_norm()));
    for (unsigned int k = 0; k < current.locally_owned_size(); ++k)
      image.local_element(k) = 1. + std::pow(0.9, 1. + k % n_rates) * current.local_element(k);
    Vector difference = image;
    difference -= current;
    return difference.linfty_norm();
  }
} // namespace

TEST(FixedPoint, DependentDifferences)
{
  for (const unsigned int n : {1, 2, 3, 8, 20})
    for (const unsigned int n_rates : {1, 2, 3, 7})
      {
        FixedPoint fixed_point([&](const Vector &current,
                                   Vector &image) { return contraction(n_rates, current, image); },
                               FixedPoint::make_unknowns(n, MPI_COMM_SELF),
                               limits);
        fixed_point.run(FixedPoint::usual_depth);
        EXPECT_TRUE(fixed_point.converged()) << n << ' ' << n_rates;
        EXPECT_LE(fixed_point.n_iterations(), 30u) << n << ' ' << n_rates;
        for (unsigned int k = 0; k < n; ++k)
          {
            const double exact = 1. / (1. - std::pow(0.9, 1. + k % n_rates));
            // the difference 1e-8 is 1 - rate of the distance
            EXPECT_NEAR(fixed_point.best().local_element(k), exact, 1e-8 / 0.1);
          }
      }
}

TEST(FixedPoint, ConstantFunction)
{
  unsigned int evaluations = 0;
  FixedPoint   fixed_point(
    [&](const Vector &current, Vector &image) {
      EXPECT_TRUE(std::isfinite(current.l1_norm()));
      image = 3.;
      ++evaluations;
      return std::abs(current.linfty_norm() - 3.) + 1e-9; // round-off above what is aimed at
    },
    FixedPoint::make_unknowns(4, MPI_COMM_SELF),
    limits);
  fixed_point.run(FixedPoint::usual_depth);
  EXPECT_TRUE(fixed_point.converged());
  EXPECT_EQ(fixed_point.n_iterations(), evaluations);
  EXPECT_EQ(fixed_point.best().linfty_norm(), 3.);
}

TEST(FixedPoint, NoFixedPoint)
{
  FixedPoint fixed_point(
    [&](const Vector &current, Vector &image) {
      EXPECT_TRUE(std::isfinite(current.l1_norm()));
      image = current;
      image.add(1.);
      return 1.;
    },
    FixedPoint::make_unknowns(4, MPI_COMM_SELF),
    limits);
  fixed_point.run(FixedPoint::usual_depth);
  EXPECT_FALSE(fixed_point.converged());
  EXPECT_LE(fixed_point.n_iterations(), limits.maximum_iterations);
}
