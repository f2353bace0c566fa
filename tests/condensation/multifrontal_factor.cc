// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A sparse matrix is eliminated as a full one would be, whatever its pattern, the size of its nodes
// and the number of rows that stay: what is left is the Schur complement, and both halves of a
// solution together solve the system. A matrix that is not definite is refused.

#include <signorini/base/user_error.h>
#include <signorini/condensation/multifrontal_factor.h>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <random>

using namespace signorini;

namespace
{
  /** Nodes of one to three rows; some are coupled to earlier ones, the diagonal rules. */
  struct Problem
  {
    std::vector<int> node_starts = {0};
    Eigen::MatrixXd  matrix;

    Problem(const unsigned int seed, const int n_nodes, const double couplings_per_node)
    {
      std::mt19937                           random(seed);
      std::uniform_real_distribution<double> number(-1., 1.);
      for (int node = 0; node < n_nodes; ++node)
        node_starts.push_back(node_starts.back() + 1 + random() % 3);
      const int n = node_starts.back();
      matrix      = Eigen::MatrixXd::Zero(n, n);
      for (int node = 0; node < n_nodes; ++node)
        for (int other = 0; other <= node; ++other)
          if (other == node || random() % n_nodes < couplings_per_node)
            for (int i = node_starts[node]; i < node_starts[node + 1]; ++i)
              for (int j = node_starts[other]; j < node_starts[other + 1]; ++j)
                matrix(i, j) = matrix(j, i) = number(random);
      for (int i = 0; i < n; ++i)
        matrix(i, i) = 1. + matrix.row(i).lpNorm<1>();
    }

    Eigen::SparseMatrix<double> lower() const
    {
      return Eigen::MatrixXd(matrix.triangularView<Eigen::Lower>()).sparseView();
    }
  };


  void expect_solution(const Problem &problem, const int n_eliminated)
  {
    const auto              &K = problem.matrix;
    const int                n = K.rows(), m = problem.node_starts[n_eliminated], left = n - m;
    const MultifrontalFactor factor(problem.lower(), problem.node_starts, n_eliminated);
    const Eigen::MatrixXd   &schur = factor.schur_complement();
    ASSERT_EQ(schur.rows(), left);
    if (m > 0 && left > 0)
      {
        const Eigen::MatrixXd coupling = K.topRightCorner(m, left);
        const Eigen::MatrixXd expected =
          K.bottomRightCorner(left, left)
          - coupling.transpose() * K.topLeftCorner(m, m).llt().solve(coupling);
        EXPECT_LT((schur - expected).norm(), 1e-13 * K.norm());
      }
    const Eigen::VectorXd force  = Eigen::VectorXd::LinSpaced(n, -1., 2.);
    Eigen::VectorXd       values = force;
    factor.eliminate(values.data());
    if (left > 0)
      values.tail(left) = schur.llt().solve(Eigen::VectorXd(values.tail(left)));
    factor.substitute(values.data());
    EXPECT_LT((K * values - force).norm(), 1e-13 * force.norm()) << n_eliminated << " nodes";
  }
} // namespace

TEST(MultifrontalFactors, SolveWhatAFullMatrixSolves)
{
  for (unsigned int seed = 0; seed < 40; ++seed)
    {
      const int     n_nodes = 1 + 3 * seed % 37;
      const Problem problem(seed, n_nodes, 0.2 * (seed % 15));
      for (const int n_eliminated : {0, n_nodes / 2, n_nodes - 1, n_nodes})
        expect_solution(problem, n_eliminated);
    }
  const Problem large(3, 150, 6.); // with panels that have zeros in them
  for (const int n_eliminated : {75, 150})
    expect_solution(large, n_eliminated);
}

TEST(MultifrontalFactors, AreOfDefiniteMatrices)
{
  Problem problem(7, 12, 3.);
  problem.matrix(3, 3) = -1.;
  EXPECT_THROW(MultifrontalFactor(problem.lower(), problem.node_starts, 12), StepError);
  // What is not eliminated may be anything.
  Problem other(7, 12, 3.);
  other.matrix(other.matrix.rows() - 1, other.matrix.rows() - 1) = -100.;
  EXPECT_NO_THROW(MultifrontalFactor(other.lower(), other.node_starts, 11));
}
