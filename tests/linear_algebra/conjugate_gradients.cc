// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Conjugate gradients find the dense solution with some entries held, carry b - Kx of all entries
// along, know how far they are, and find the same solution on any number of processes.

#include <signorini/linear_algebra/conjugate_gradients.h>
#include <signorini/linear_algebra/lanczos.h>

#include <gtest/gtest.h>

#include "held_nodes.h"

using namespace signorini;

namespace
{
  constexpr int    dim = 2;
  constexpr double a = 1., b = 0.02;

  class Matrix : public LinearOperator
  {
  public:
    explicit Matrix(const ElasticMatrices<dim> &matrices)
      : matrices(matrices)
    {
    }
    void vmult(Vector &destination, const Vector &source) const override
    {
      matrices.apply(destination, source, {a, b});
    }
    void diagonal(Vector &) const override { FAIL() << "conjugate gradients need no diagonal"; }

  private:
    const ElasticMatrices<dim> &matrices;
  };

  /** The incomplete factor with nodes at the face x = 0 held in both directions. */
  class Preconditioner : public MaskedPreconditioner
  {
  public:
    explicit Preconditioner(const SmallBody<dim> &body)
      : factor(body.matrices, {a, b}, {})
    {
      for (unsigned int node = 0; node < body.matrices.pattern.n_local; ++node)
        if (body.discretization.node_positions()[node][0] < 1e-12 && !body.is_hanging(node))
          held.push_back(held_in_turned_frame<dim>(node, 0., all_directions<dim>()));
      factor.set_held_nodes(held);
    }
    void set_mask(const Mask &) override { FAIL() << "conjugate gradients do not choose the mask"; }
    void vmult(Vector &destination, const Vector &source) const override
    {
      factor.vmult(destination, source);
    }

    HeldNodes<dim> held;

  private:
    IncompleteCholesky<dim, dim> factor;
  };

  /** K x = right-hand side with the guess as value of the held entries. */
  struct LinearSystem
  {
    explicit LinearSystem(const MPI_Comm communicator)
      : body(make_boxes<dim>(1, 2, true), communicator)
      , matrix(body.matrices)
      , preconditioner(body)
      , right_hand_side(body.some_vector(0.5))
      , solution(body.some_vector(2.))
      , residual(solution)
      , guess(solution)
    {
      residual = true_residual();
    }

    Vector true_residual() const
    {
      Vector result(solution);
      matrix.vmult(result, solution);
      result.sadd(-1., 1., right_hand_side);
      return result;
    }

    LinearReport solve(const double       tolerance,
                       const double       reduction          = 0.,
                       const unsigned int maximum_iterations = 200)
    {
      return ConjugateGradients().solve(
        matrix, preconditioner, solution, residual, tolerance, reduction, maximum_iterations);
    }

    SmallBody<dim> body;
    Matrix         matrix;
    Preconditioner preconditioner;
    Vector         right_hand_side, solution, residual, guess;
  };

  Eigen::VectorXd to_eigen(const Vector &x)
  {
    return Eigen::Map<const Eigen::VectorXd>(x.begin(), x.locally_owned_size());
  }

  /** The exact correction of the guess. Empty (hanging) rows get a unit diagonal. */
  struct DenseSolution
  {
    explicit DenseSolution(const LinearSystem &system)
      : K(dense([&](Vector &y, const Vector &x) { system.matrix.vmult(y, x); }, system.solution))
    {
      Eigen::MatrixXd regular = K;
      for (int i = 0; i < K.rows(); ++i)
        regular(i, i) += K(i, i) == 0.;
      x = to_eigen(system.guess)
          + inverse_on_free_directions<dim>(regular, system.preconditioner.held)
              * to_eigen(system.true_residual());
    }

    double error_norm(const Vector &solution) const
    {
      const Eigen::VectorXd error = to_eigen(solution) - x;
      return std::sqrt(error.dot(K * error));
    }

    Eigen::MatrixXd K;
    Eigen::VectorXd x;
  };
} // namespace

TEST(ConjugateGradients, ConvergeToTheDenseSolution)
{
  LinearSystem        system(MPI_COMM_SELF);
  const DenseSolution exact(system);
  const auto          report = system.solve(1e-12);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.iterations, 30u);
  EXPECT_LT((to_eigen(system.solution) - exact.x).norm(), 1e-10);
  for (const auto &node : system.preconditioner.held)
    for (unsigned int c = 0; c < dim; ++c)
      EXPECT_EQ(system.solution(dim * node.node + c), system.guess(dim * node.node + c));
}

TEST(ConjugateGradients, TheResidualIsThatOfAllEntries)
{
  LinearSystem system(MPI_COMM_WORLD);
  system.solve(1e-12);
  Vector       difference = system.true_residual();
  const double size       = difference.linfty_norm(); // the forces that hold the held entries
  difference -= system.residual;
  EXPECT_LT(difference.linfty_norm(), 1e-12);
  EXPECT_GT(size, 1e-3);
}

TEST(ConjugateGradients, TheToleranceIsTheErrorInTheNormOfTheMatrix)
{
  for (const double tolerance : {1e-2, 1e-5, 1e-8})
    {
      LinearSystem        system(MPI_COMM_SELF);
      const DenseSolution exact(system);
      EXPECT_GT(exact.error_norm(system.solution), 0.1);
      EXPECT_TRUE(system.solve(tolerance).converged);
      EXPECT_LT(exact.error_norm(system.solution), 2. * tolerance);
      EXPECT_GT(exact.error_norm(system.solution), 1e-4 * tolerance) << "more work than asked for";
    }
}

TEST(ConjugateGradients, NeedOneIterationPerEigenvalue)
{
  class ThreeEigenvalues : public LinearOperator
  {
  public:
    void vmult(Vector &destination, const Vector &source) const override
    {
      for (const auto i : source.locally_owned_elements())
        destination(i) = (i % 3 == 0 ? 1. : i % 3 == 1 ? 7. : 50.) * source(i);
    }
    void diagonal(Vector &) const override {}
  };
  class Identity : public MaskedPreconditioner
  {
  public:
    void set_mask(const Mask &) override {}
    void vmult(Vector &destination, const Vector &source) const override { destination = source; }
  };
  Vector solution(12), residual(12);
  for (unsigned int i = 0; i < 12; ++i)
    residual(i) = std::cos(i);
  const auto report =
    ConjugateGradients().solve(ThreeEigenvalues(), Identity(), solution, residual, 1e-12, 0., 100);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 3u);
}

// The square of the "norm" of the residual is negative then, which is not the same as small.
TEST(ConjugateGradients, ANegativePreconditionerIsNoConvergence)
{
  class Identity : public LinearOperator
  {
  public:
    void vmult(Vector &destination, const Vector &source) const override { destination = source; }
    void diagonal(Vector &) const override {}
  };
  class Scaling : public MaskedPreconditioner
  {
  public:
    explicit Scaling(const double factor)
      : factor(factor)
    {
    }
    void set_mask(const Mask &) override {}
    void vmult(Vector &destination, const Vector &source) const override
    {
      destination = source;
      destination *= factor;
    }
    const double factor;
  };
  const auto converges = [](const double factor, const double size) {
    Vector solution(12), residual(12);
    residual = size;
    const auto report =
      ConjugateGradients().solve(Identity(), Scaling(factor), solution, residual, 1e-12, 0., 100);
    EXPECT_EQ(solution.linfty_norm() > 0., report.iterations > 0);
    return report.converged;
  };
  EXPECT_TRUE(converges(1., 1.));
  EXPECT_FALSE(converges(-1., 1.));
  EXPECT_TRUE(converges(-1., 0.));    // nothing to do
  EXPECT_TRUE(converges(-1., 1e-15)); // round-off of no importance
}

TEST(ConjugateGradients, StopWhereTheyAreTold)
{
  LinearSystem rough(MPI_COMM_WORLD), accurate(MPI_COMM_WORLD), limited(MPI_COMM_WORLD);
  const auto   rough_report = rough.solve(1e-12, 1e-2), accurate_report = accurate.solve(1e-12);
  EXPECT_TRUE(rough_report.converged);
  EXPECT_GT(rough_report.iterations, 0u);
  EXPECT_LT(2 * rough_report.iterations, accurate_report.iterations);
  EXPECT_EQ(accurate.solve(1e-11).iterations, 0u); // nothing left to do
  const auto limited_report = limited.solve(1e-12, 0., 2);
  EXPECT_FALSE(limited_report.converged);
  EXPECT_EQ(limited_report.iterations, 2u);
}

// Errors of guesses add up from step to step: one that is just within the tolerance is improved
// tenfold, one of a thousandth is not touched.
TEST(ConjugateGradients, AGuessHasToBeBetterThanASolution)
{
  constexpr double found = 1e-8;
  const auto iterations  = [](LinearSystem &system, const double tolerance, const bool is_guess) {
    const auto report = ConjugateGradients().solve(system.matrix,
                                                   system.preconditioner,
                                                   system.solution,
                                                   system.residual,
                                                   tolerance,
                                                   0.5,
                                                   200,
                                                   is_guess);
    EXPECT_TRUE(report.converged);
    return report.iterations;
  };
  LinearSystem system(MPI_COMM_WORLD);
  system.solve(found);
  EXPECT_EQ(iterations(system, 2. * found, false), 0u);
  EXPECT_EQ(iterations(system, 1000. * found, true), 0u);
  EXPECT_GT(iterations(system, 2. * found, true), 0u);
  EXPECT_EQ(iterations(system, 0.1 * found, false), 0u) << "this has made it ten times as good";
}

TEST(ConjugateGradients, AnyNumberOfProcessesFindsTheSameSolution)
{
  LinearSystem distributed(MPI_COMM_WORLD), serial(MPI_COMM_SELF);
  distributed.solve(1e-12);
  serial.solve(1e-12);
  const auto &here        = distributed.body.discretization.node_positions(),
             &all         = serial.body.discretization.node_positions();
  unsigned int n_compared = 0;
  for (unsigned int p = 0; p < distributed.body.matrices.pattern.n_owned; ++p)
    for (unsigned int q = 0; q < all.size(); ++q)
      for (unsigned int c = 0; c < dim && here[p].distance(all[q]) < 1e-10; ++c, ++n_compared)
        EXPECT_NEAR(
          distributed.solution.local_element(dim * p + c), serial.solution(dim * q + c), 1e-10);
  EXPECT_EQ(dealii::Utilities::MPI::sum(n_compared, MPI_COMM_WORLD), serial.solution.size());
}

TEST(LanczosMatrix, KnowsTheSmallestEigenvalue)
{
  EXPECT_EQ(LanczosMatrix().smallest_eigenvalue(), 1.);
  // Conjugate gradients on a diagonal matrix, without a preconditioner.
  const Eigen::VectorXd diagonal = (Eigen::VectorXd(6) << 0.003, 0.4, 1., 2., 5., 9.).finished();
  Eigen::VectorXd       residual = Eigen::VectorXd::Ones(6), direction = residual;
  LanczosMatrix         lanczos;
  for (int iteration = 0; iteration < 6; ++iteration)
    {
      const Eigen::VectorXd product = diagonal.cwiseProduct(direction);
      const double          before  = residual.squaredNorm();
      const double          alpha   = before / direction.dot(product);
      residual -= alpha * product;
      const double beta = residual.squaredNorm() / before;
      direction         = residual + beta * direction;
      lanczos.add(alpha, beta);
    }
  EXPECT_NEAR(lanczos.smallest_eigenvalue(), 0.003, 1e-9);
}

// A preconditioner that takes the matrix for a million times as large makes the residual look a
// thousand times smaller than the error is.
TEST(ConjugateGradients, TheToleranceBoundsTheErrorWithABadPreconditioner)
{
  class Weak : public MaskedPreconditioner
  {
  public:
    explicit Weak(const Preconditioner &good)
      : good(good)
    {
    }
    void set_mask(const Mask &) override {}
    void vmult(Vector &destination, const Vector &source) const override
    {
      good.vmult(destination, source);
      destination *= 1e-6;
    }

  private:
    const Preconditioner &good;
  };
  LinearSystem        system(MPI_COMM_SELF);
  const DenseSolution exact(system);
  const double        tolerance = 1e-6;
  const auto          report    = ConjugateGradients().solve(system.matrix,
                                                 Weak(system.preconditioner),
                                                 system.solution,
                                                 system.residual,
                                                 tolerance,
                                                 0.,
                                                 200);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(exact.error_norm(system.solution), 5. * tolerance);
}
