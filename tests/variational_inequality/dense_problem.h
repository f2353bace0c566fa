// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_dense_problem_h
#define signorini_tests_dense_problem_h

// Small dense problems with bounds whose solution is found by trying all active sets.

#include <signorini/variational_inequality/constrained_problem.h>

#include <Eigen/Dense>

#include <limits>
#include <random>

namespace signorini
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  inline Vector to_vector(const Eigen::VectorXd &x)
  {
    Vector result(x.size());
    std::copy(x.data(), x.data() + x.size(), result.begin());
    return result;
  }

  inline Eigen::VectorXd to_eigen(const Vector &x)
  {
    return Eigen::Map<const Eigen::VectorXd>(x.begin(), x.locally_owned_size());
  }

  /** A dense matrix, or, on several processes, the block-diagonal matrix of one such block each. */
  class DenseOperator : public LinearOperator
  {
  public:
    explicit DenseOperator(const Eigen::MatrixXd &matrix)
      : matrix(matrix)
    {
    }

    void vmult(Vector &destination, const Vector &source) const override
    {
      Eigen::Map<Eigen::VectorXd>(destination.begin(), matrix.rows()) = matrix * to_eigen(source);
    }

    void diagonal(Vector &destination) const override
    {
      Eigen::Map<Eigen::VectorXd>(destination.begin(), matrix.rows()) = matrix.diagonal();
    }

    const Eigen::MatrixXd matrix;
  };

  /** The inverse of the block of the free entries, of a matrix or of what stands in for it. */
  class DenseInverse : public MaskedPreconditioner
  {
  public:
    explicit DenseInverse(const Eigen::MatrixXd &matrix)
      : matrix(matrix)
    {
    }

    void set_mask(const Mask &mask) override
    {
      Eigen::MatrixXd masked = matrix;
      for (unsigned int i = 0; i < mask.size(); ++i)
        if (mask[i])
          {
            masked.row(i).setZero();
            masked.col(i).setZero();
            masked(i, i) = 1.;
          }
      inverse = masked.inverse();
      for (unsigned int i = 0; i < mask.size(); ++i)
        if (mask[i])
          inverse(i, i) = 0.;
    }

    void vmult(Vector &destination, const Vector &source) const override
    {
      Eigen::Map<Eigen::VectorXd>(destination.begin(), matrix.rows()) = inverse * to_eigen(source);
    }

  private:
    const Eigen::MatrixXd matrix;
    Eigen::MatrixXd       inverse;
  };

  /** Data of a ConstrainedProblem. */
  struct DenseProblem
  {
    Eigen::MatrixXd           matrix;
    Eigen::VectorXd           right_hand_side;
    std::vector<unsigned int> bounded_entries;
    std::vector<double>       upper_bounds;
    std::vector<unsigned int> fixed_entries;
    std::vector<double>       fixed_values;
  };

  /**
   * All entries but two are bounded, one of them by infinity; the last but one is free, the last
   * one is fixed.
   */
  inline DenseProblem random_problem(const Eigen::MatrixXd &matrix, std::mt19937 &generator)
  {
    std::uniform_real_distribution<double> number(-1., 1.);
    DenseProblem                           problem;
    const unsigned int                     n = matrix.rows();
    problem.matrix                           = matrix;
    problem.right_hand_side =
      matrix * Eigen::VectorXd::NullaryExpr(n, [&] { return number(generator); });
    for (unsigned int i = 0; i + 2 < n; ++i)
      {
        problem.bounded_entries.push_back(i);
        problem.upper_bounds.push_back(i == 1 ? infinity : 0.5 * number(generator));
      }
    problem.fixed_entries = {n - 1};
    problem.fixed_values  = {number(generator)};
    return problem;
  }

  /** The solution with some entries at their bounds. */
  inline Eigen::VectorXd solve_with(const DenseProblem &problem, const ActiveSet &active)
  {
    const unsigned int n = problem.matrix.rows();
    Mask               mask(n, 0);
    Eigen::VectorXd    held = Eigen::VectorXd::Zero(n);
    for (unsigned int j = 0; j < problem.fixed_entries.size(); ++j)
      {
        mask[problem.fixed_entries[j]] = 1;
        held[problem.fixed_entries[j]] = problem.fixed_values[j];
      }
    for (unsigned int k = 0; k < active.size(); ++k)
      if (active[k])
        {
          mask[problem.bounded_entries[k]] = 1;
          held[problem.bounded_entries[k]] = problem.upper_bounds[k];
        }
    DenseInverse inverse(problem.matrix);
    inverse.set_mask(mask);
    Vector correction(n);
    inverse.vmult(correction, to_vector(problem.right_hand_side - problem.matrix * held));
    return held + to_eigen(correction);
  }

  /**
   * The least energy among the admissible solutions of all active sets: the definition, in
   * exponential time.
   */
  inline Eigen::VectorXd brute_force(const DenseProblem &problem)
  {
    const std::size_t m           = problem.bounded_entries.size();
    double            best_energy = infinity;
    Eigen::VectorXd   best;
    for (unsigned int set = 0; set < (1u << m); ++set)
      {
        ActiveSet active(m);
        bool      possible = true;
        for (unsigned int k = 0; k < m; ++k)
          {
            active[k] = (set >> k) & 1;
            possible &= !active[k] || problem.upper_bounds[k] < infinity;
          }
        if (!possible)
          continue;
        const Eigen::VectorXd x = solve_with(problem, active);
        for (unsigned int k = 0; k < m; ++k)
          possible &= x[problem.bounded_entries[k]] <= problem.upper_bounds[k] + 1e-13;
        const double energy = 0.5 * x.dot(problem.matrix * x) - problem.right_hand_side.dot(x);
        if (possible && energy < best_energy)
          {
            best_energy = energy;
            best        = x;
          }
      }
    return best;
  }
} // namespace signorini

#endif
