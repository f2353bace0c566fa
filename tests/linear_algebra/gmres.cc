// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// GMRES on dense unsymmetric matrices with a masked preconditioner: the solution of the free
// entries, exact residuals in all entries (held ones included), also when the space is exhausted,
// after restarts and from a right-hand side of any size.

#include <signorini/linear_algebra/gmres.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  Vector to_vector(const Eigen::VectorXd &x)
  {
    Vector result(x.size());
    std::copy(x.data(), x.data() + x.size(), result.begin());
    return result;
  }

  Eigen::VectorXd eigen_of(const Vector &x)
  {
    return Eigen::Map<const Eigen::VectorXd>(x.begin(), x.size());
  }

  /**
   * Solve J x = b in the entries that are not held, with the diagonal of J as preconditioner.
   * @return iterations
   */
  unsigned int
  expect_solution(const Eigen::MatrixXd &J, const std::vector<char> &held, const double scale)
  {
    const Eigen::Index    n = J.rows();
    const Eigen::VectorXd b = scale * Eigen::VectorXd::LinSpaced(n, -1., 2.);
    const auto apply        = [&](Vector &y, const Vector &x) { y = to_vector(J * eigen_of(x)); };
    const auto precondition = [&](Vector &y, const Vector &x) {
      for (Eigen::Index i = 0; i < n; ++i)
        y(i) = held[i] ? 0. : x(i) / J(i, i);
    };
    Eigen::MatrixXd reduced = J;
    Eigen::VectorXd right   = b;
    for (Eigen::Index i = 0; i < n; ++i)
      if (held[i])
        {
          reduced.row(i).setZero();
          reduced(i, i) = 1.;
          right[i]      = 0.;
        }
    const Eigen::VectorXd expected = reduced.partialPivLu().solve(right);

    Gmres      gmres;
    Vector     x(n), residual = to_vector(b);
    const auto report = gmres.solve(apply, precondition, x, residual, [&](double) {
      return SolverLimits{1e-13 * scale, 0., 1000, false};
    });
    EXPECT_TRUE(report.converged);
    EXPECT_LT((eigen_of(x) - expected).lpNorm<Eigen::Infinity>(), 1e-11 * scale);
    EXPECT_LT((eigen_of(residual) - (b - J * eigen_of(x))).lpNorm<Eigen::Infinity>(),
              1e-11 * scale);
    return report.iterations;
  }

  /** Symmetric positive definite but for some rows. */
  Eigen::MatrixXd matrix(const Eigen::Index n, const double diagonal = 2.5)
  {
    Eigen::MatrixXd J = diagonal * Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i + 1 < n; ++i)
      J(i, i + 1) = J(i + 1, i) = -1.;
    for (Eigen::Index i = 1; i < n; i += 4)
      J.row(i) -= 0.4 * J.row(i - 1);
    return J;
  }
} // namespace

TEST(Gmres, SolvesTheFreeEntries)
{
  for (const double scale : {1e-9, 1., 1e9})
    {
      std::vector<char> held(20, 0);
      expect_solution(matrix(20), held, scale);
      held[3] = held[8] = held[9] = 1;
      expect_solution(matrix(20), held, scale);
    }
}

TEST(Gmres, SurvivesAnExhaustedSpace)
{
  std::vector<char> held(20, 1);
  held[4] = held[5] = 0; // two free entries: the space is exhausted after two products
  expect_solution(matrix(20), held, 1.);
  held.assign(20, 1);
  expect_solution(matrix(20), held, 1.);
}

TEST(Gmres, Restarts)
{
  // So badly conditioned that it needs more products than a basis has room for.
  EXPECT_GT(expect_solution(matrix(300, 2.02), std::vector<char>(300, 0), 1.), 50u);
}

TEST(Gmres, StopsAtItsGoal)
{
  const Eigen::MatrixXd J     = matrix(40);
  const auto            apply = [&](Vector &y, const Vector &x) { y = to_vector(J * eigen_of(x)); };
  const auto            precondition = [&](Vector &y, const Vector &x) { y = x; };
  Gmres                 gmres;
  Vector                x(40), residual = to_vector(Eigen::VectorXd::Ones(40));
  double                initial = 0.;
  const auto report = gmres.solve(apply, precondition, x, residual, [&](const double norm) {
    initial = norm;
    return SolverLimits{0., 0.1, 100, false};
  });
  EXPECT_TRUE(report.converged);
  EXPECT_DOUBLE_EQ(initial, std::sqrt(40.));
  EXPECT_LE(residual.l2_norm(), 0.1 * initial);
  EXPECT_GT(residual.l2_norm(), 1e-4 * initial);
}

// What the carried residual has lost against b - J x is no more than is said, also where the
// preconditioner computes in single precision and the space is exhausted.
TEST(Gmres, RoundOffOfTheResidualIsKnown)
{
  const Eigen::Index n = 9;
  Eigen::MatrixXd    J = matrix(n);
  for (Eigen::Index i = 0; i < n; ++i) // entries of many sizes
    {
      const double scale = std::pow(10., static_cast<double>(i % 4));
      J.row(i) *= scale;
      J.col(i) *= scale;
    }
  const Eigen::MatrixXf inverse =
    (0.5 * (J + J.transpose()) + 0.3 * J.diagonal().asDiagonal().toDenseMatrix())
      .inverse()
      .cast<float>();
  const auto apply        = [&](Vector &y, const Vector &x) { y = to_vector(J * eigen_of(x)); };
  const auto precondition = [&](Vector &y, const Vector &x) {
    y = to_vector((inverse * eigen_of(x).cast<float>()).cast<double>());
  };
  const auto norm = [&](const Eigen::VectorXd &r) {
    return std::sqrt(std::abs(r.dot(inverse.cast<double>() * r)));
  };
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1., 2.);
  for (const double goal : {1e-6, 1e-9, 1e-12, 1e-15})
    {
      Gmres      gmres;
      Vector     x(n), residual = to_vector(b);
      const auto report = gmres.solve(apply, precondition, x, residual, [&](double) {
        return SolverLimits{0., goal, 200, false};
      });
      EXPECT_TRUE(report.converged) << goal;
      EXPECT_LT(report.iterations, 60u) << goal;
      const double lost = norm(eigen_of(residual) - (b - J * eigen_of(x)));
      EXPECT_LE(lost, 10. * gmres.round_off()) << goal;
      EXPECT_LT(gmres.round_off(), 1e-13 * norm(b)) << goal;
    }
}

// The square of the "norm" of the residual is negative then, which is not the same as small.
TEST(Gmres, ANegativePreconditionerIsNoConvergence)
{
  const auto converges = [](const double factor, const double size) {
    const auto apply        = [](Vector &y, const Vector &x) { y = x; };
    const auto precondition = [&](Vector &y, const Vector &x) {
      y = x;
      y *= factor;
    };
    Vector     x(12), residual = to_vector(size * Eigen::VectorXd::Ones(12));
    const auto report = Gmres().solve(apply, precondition, x, residual, [](double) {
      return SolverLimits{1e-12, 0., 100, false};
    });
    EXPECT_EQ(x.linfty_norm() > 0., report.iterations > 0);
    return report.converged;
  };
  EXPECT_TRUE(converges(1., 1.));
  EXPECT_FALSE(converges(-1., 1.));
  EXPECT_TRUE(converges(-1., 0.));    // nothing to do
  EXPECT_TRUE(converges(-1., 1e-15)); // round-off of no importance
}
