// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A factor with chosen nodes at its end. The Schur complement is what products with the matrix say:
// forces of a displacement that leaves no force on the other nodes are S times that of the chosen
// ones. And what a force is for the chosen nodes gives, with any displacement of them, the one
// displacement of the others that is in balance.

#include "../multigrid/level_problems.h"

#include <signorini/condensation/nodal_factor.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double accuracy = 1e-11;

  template <int dim>
  void expect_balance(const Scene<dim> &scene, const double courant_number)
  {
    const LevelProblem<dim>         problem(scene);
    const auto                     &matrices = problem.matrices();
    const MatrixSum                 sum      = problem.step(courant_number);
    const std::vector<unsigned int> last     = problem.coordinates.contact_nodes();
    std::vector<char>               held(dim * matrices.pattern.n_owned, 0), is_last(held);
    for (const unsigned int entry : problem.coordinates.dirichlet_entries())
      held[entry] = 1;
    for (const unsigned int node : last)
      std::fill_n(is_last.begin() + dim * node, dim, 1);
    NodalFactor<dim> factor(matrices, sum, held, last);

    const Vector    force = irregular_field(problem.discretization, 4.);
    Eigen::VectorXd u     = Eigen::VectorXd::LinSpaced(dim * last.size(), -1., 2.);
    for (Eigen::Index i = 0; i < u.size(); ++i)
      if (held[dim * last[i / dim] + i % dim])
        u[i] = 0.;
    const Eigen::VectorXd condensed = factor.condense(force);
    Vector                displacement(force), left(force);
    factor.expand(u, displacement);
    matrices.apply(left, displacement, sum);
    left.sadd(-1., 1., force);
    const double          size     = force.linfty_norm();
    const Eigen::VectorXd expected = condensed - factor.schur_complement() * u;
    for (unsigned int i = 0; i < held.size(); ++i)
      {
        const bool stays = matrices.pattern.is_empty(i / dim) || held[i];
        if (stays)
          {
            EXPECT_EQ(displacement.local_element(i), 0.);
          }
        else if (!is_last[i])
          {
            EXPECT_NEAR(left.local_element(i), 0., accuracy * size);
          }
      }
    for (Eigen::Index i = 0; i < u.size(); ++i)
      if (const unsigned int entry = dim * last[i / dim] + i % dim; !held[entry])
        {
          EXPECT_EQ(displacement.local_element(entry), u[i]);
          EXPECT_NEAR(left.local_element(entry), expected[i], 100. * accuracy * size);
        }
  }
} // namespace

TEST(NodalFactors, LeaveNoForceOnOtherNodes)
{
  for (const double courant_number : {1., 30.})
    {
      expect_balance<2>(ball_on_floor<2>(4), courant_number);
      expect_balance<3>(ball_on_floor<3>(2), courant_number);
      expect_balance<2>(adaptive_box_on_floor<2>(), courant_number);
      expect_balance<3>(adaptive_box_on_floor<3>(), courant_number);
      expect_balance<2>(blocks_on_each_other<2>(2, 10.), courant_number);
    }
}

TEST(NodalFactors, AreOfAnyChoiceOfNodes)
{
  const LevelProblem<2>     problem(ball_on_floor<2>(2));
  const auto               &matrices = problem.matrices();
  const unsigned int        n        = matrices.pattern.n_owned;
  std::vector<unsigned int> all(n);
  std::iota(all.begin(), all.end(), 0);
  const Vector force = irregular_field(problem.discretization, 4.);
  for (const auto &last : {std::vector<unsigned int>(), std::vector<unsigned int>{3}, all})
    {
      NodalFactor<2>        factor(matrices, problem.step(5.), std::vector<char>(2 * n, 0), last);
      const Eigen::VectorXd condensed = factor.condense(force);
      Vector                displacement(force), left(force);
      Eigen::VectorXd       u = condensed;
      if (!last.empty())
        u = factor.schur_complement().ldlt().solve(condensed);
      factor.expand(u, displacement);
      matrices.apply(left, displacement, problem.step(5.));
      left -= force;
      EXPECT_LT(left.linfty_norm(), accuracy * force.linfty_norm()) << last.size();
    }
}
