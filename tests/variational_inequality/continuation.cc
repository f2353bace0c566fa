// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A problem whose bounds have changed a little has the same solution from the iterate and the
// residual of the old one as from nothing: the solution is unique. From there it takes one product
// for the bounds and one for an iteration with the exact inverse. A rough solution has the right
// set, and a small part of the error of its guess.

#include <gtest/gtest.h>

#include "solvers.h"

#include <cmath>

using namespace signorini;

namespace
{
  class CountingOperator : public DenseOperator
  {
  public:
    using DenseOperator::DenseOperator;

    void vmult(Vector &destination, const Vector &source) const override
    {
      ++n_products;
      DenseOperator::vmult(destination, source);
    }

    mutable unsigned int n_products = 0;
  };

  /** A random problem, its solution, and one with bounds that are by 1e-3 higher. */
  class Continuation : public testing::TestWithParam<SolverCase>
  {
  protected:
    std::mt19937           random{5};
    DenseProblem           problem = random_problem(make_matrix(), random), changed = change();
    const CountingOperator matrix               = CountingOperator(problem.matrix);
    DenseInverse           inverse              = DenseInverse(preconditioner());
    const Vector           force                = to_vector(problem.right_hand_side);
    std::unique_ptr<ConstrainedSolver> solver   = GetParam().make_solver();
    ActiveSet                          active   = ActiveSet(problem.bounded_entries.size(), 0);
    Vector                             solution = Vector(n), residual = Vector(n);

    SolveReport solve(const DenseProblem &data, const bool continues, const bool is_rough)
    {
      matrix.n_products = 0;
      return solver->solve({matrix,
                            inverse,
                            force,
                            data.bounded_entries,
                            data.upper_bounds,
                            data.fixed_entries,
                            data.fixed_values,
                            1e-11,
                            1e-12,
                            ConstrainedProblem::no_friction,
                            continues,
                            is_rough},
                           active,
                           solution,
                           residual);
    }

    double error(const Eigen::VectorXd &exact) const
    {
      const Eigen::VectorXd e = to_eigen(solution) - exact;
      return std::sqrt(e.dot(problem.matrix * e));
    }

    bool is_active_set() const { return std::string(GetParam().solver) == "active_set"; }
    bool is_exact() const { return std::string(GetParam().preconditioner) == "exact"; }

  private:
    static constexpr unsigned int n = 9;

    Eigen::MatrixXd make_matrix()
    {
      std::uniform_real_distribution<double> number(-1., 1.);
      const Eigen::MatrixXd                  half =
        Eigen::MatrixXd::NullaryExpr(n, n, [&] { return number(random); });
      return half * half.transpose() + Eigen::MatrixXd::Identity(n, n);
    }

    DenseProblem change() const
    {
      DenseProblem result = problem;
      for (double &bound : result.upper_bounds)
        bound += 1e-3;
      return result;
    }

    Eigen::MatrixXd preconditioner() const
    {
      return is_exact() ? problem.matrix : Eigen::MatrixXd(problem.matrix.diagonal().asDiagonal());
    }
  };
} // namespace


TEST_P(Continuation, LeadsToTheSolutionOfTheNewProblem)
{
  solve(problem, false, false);
  EXPECT_LT(error(brute_force(problem)), 1e-10);
  const ActiveSet before = active;
  EXPECT_NE(before, ActiveSet(active.size(), 0));

  solve(changed, true, false);
  EXPECT_LT(error(brute_force(changed)), 1e-10);
  EXPECT_EQ(active, before);
  const Eigen::VectorXd expected = problem.right_hand_side - problem.matrix * to_eigen(solution);
  EXPECT_LT((to_eigen(residual) - expected).norm(), 1e-12);
  if (is_active_set() && is_exact())
    {
      EXPECT_EQ(matrix.n_products, 2u);
    }
}


TEST_P(Continuation, OfARoughSolutionIsAsGood)
{
  const Eigen::VectorXd exact = brute_force(problem);
  const double          start = error(exact);
  const unsigned int    rough = solve(problem, false, true).linear_iterations;
  EXPECT_LT(error(exact), 0.1 * start);
  for (std::size_t k = 0; k < active.size(); ++k)
    EXPECT_EQ(active[k] != 0, exact[k] >= problem.upper_bounds[k] - 1e-12);

  solve(changed, true, false);
  EXPECT_LT(error(brute_force(changed)), 1e-10);

  solution                = 0.;
  active                  = ActiveSet(active.size(), 0);
  const unsigned int full = solve(problem, false, false).linear_iterations;
  if (is_active_set() && !is_exact())
    {
      EXPECT_LT(rough, full);
    }
}


INSTANTIATE_TEST_SUITE_P(All,
                         Continuation,
                         testing::ValuesIn(solver_cases),
                         testing::PrintToStringParamName());
