// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The minimisation with given bounds of friction, where Newton's method for Coulomb's law ends when
// it fails. A node either sticks, with no slip at all and the force within its bound that balances
// it, or it slips by more than round-off, and then the force of its bound along the slip balances
// it. In between there is nothing: a node that stops within round-off of the kink of |slip| must
// not report the force of its bound, when less holds it. The minimum is the only one: it does not
// depend on the guess. A tolerance below round-off is met as well as round-off lets it: the minimum
// of a million times larger data is a million times that of the data.

#include <signorini/base/user_error.h>
#include <signorini/variational_inequality/tresca_minimisation.h>

#include "frictional_problem.h"

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  FrictionalAnswer minimise(const FrictionalProblem   &data,
                            const std::vector<double> &bounds,
                            const Eigen::VectorXd     &guess)
  {
    return solve_with(
      [&](const ConstrainedProblem &problem, ActiveSet &status, Vector &x, Vector &residual) {
        return TrescaMinimisation().solve(problem, bounds, status, x, residual);
      },
      data,
      guess,
      false);
  }

  /** @return the number of nodes that stick */
  unsigned int expect_minimum(const FrictionalProblem   &problem,
                              const std::vector<double> &bounds,
                              const FrictionalAnswer    &answer)
  {
    const Eigen::VectorXd residual = problem.right_hand_side - problem.matrix * answer.solution;
    EXPECT_LT((residual - answer.residual).lpNorm<Eigen::Infinity>(), 1e-11);
    unsigned int n_stick = 0;
    for (unsigned int k = 0; k < bounds.size(); ++k)
      {
        const NodeForces node = forces_at(problem, answer, k);
        const double gap    = problem.upper_bounds[k] - answer.solution[problem.bounded_entries[k]];
        const double normal = residual[problem.bounded_entries[k]];
        EXPECT_GE(gap, 0.) << k;
        EXPECT_GE(normal, -1e-11) << k;
        EXPECT_NEAR(gap * normal, 0., 1e-11) << k;
        if (contact_status::sticks(answer.status[k]))
          {
            ++n_stick;
            EXPECT_EQ(node.slip.norm(), 0.) << k;
            EXPECT_LE(node.tangential.norm(), bounds[k] * (1. + 1e-12)) << k;
          }
        else
          {
            // The stiffness is about one: smaller slips are round-off of these forces.
            EXPECT_GT(node.slip.norm(), 1e-12 * bounds[k]) << k;
            const TangentVector reported = slip_force({0., bounds[k]}, node, 1e17);
            EXPECT_LT((reported - node.tangential).norm(), 1e-9)
              << "node " << k << " slips by " << node.slip.norm();
          }
      }
    return n_stick;
  }
  /** Motion along one line in each node, in 3d with tangents across this line. */
  FrictionalProblem along_lines(const FrictionalProblem &plane)
  {
    const unsigned int n = plane.friction.size(), size = 3 * n + 2;
    Eigen::MatrixXd    embed = Eigen::MatrixXd::Zero(size, 2 * n + 2),
                    across   = Eigen::MatrixXd::Zero(size, n);
    FrictionalProblem problem;
    problem.upper_bounds = plane.upper_bounds;
    for (unsigned int k = 0; k < n; ++k)
      {
        const double angle          = 0.3 + k;
        embed(3 * k, 2 * k)         = 1.;
        embed(3 * k + 1, 2 * k + 1) = across(3 * k + 2, k) = std::cos(angle);
        embed(3 * k + 2, 2 * k + 1)                        = std::sin(angle);
        across(3 * k + 1, k)                               = -std::sin(angle);
        problem.bounded_entries.push_back(3 * k);
        problem.friction.push_back({{3 * k + 1, 3 * k + 2}, plane.friction[k].law});
      }
    for (unsigned int i = 0; i < 2; ++i)
      embed(3 * n + i, 2 * n + i) = 1.;
    problem.matrix = embed * plane.matrix * embed.transpose() + across * across.transpose();
    problem.right_hand_side = embed * plane.right_hand_side;
    return problem;
  }

  std::vector<double> random_bounds(const unsigned int seed)
  {
    std::mt19937        generator(seed);
    std::vector<double> bounds(6);
    for (double &bound : bounds)
      bound = std::uniform_real_distribution<double>(0.05, 1.)(generator);
    return bounds;
  }

  /** A strip that resists bending and stretching, on soft springs, pulled down to a rough floor. */
  FrictionalProblem
  strip(const double bending, const double stretching, const double pull, const double push)
  {
    constexpr unsigned int n       = 40;
    Eigen::MatrixXd        bend    = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd        stretch = bend;
    for (unsigned int k = 0; k + 1 < n; ++k)
      {
        Eigen::VectorXd change(Eigen::VectorXd::Zero(n));
        change[k]     = -1.;
        change[k + 1] = 1.;
        stretch += change * change.transpose();
        if (k > 0)
          {
            change[k - 1] = 1.;
            change[k]     = -2.;
            bend += change * change.transpose();
          }
      }
    FrictionalProblem problem;
    problem.matrix          = Eigen::MatrixXd::Identity(2 * n, 2 * n);
    problem.right_hand_side = Eigen::VectorXd::Zero(2 * n);
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          {
            problem.matrix(2 * i, 2 * j) += bending * bend(i, j);
            problem.matrix(2 * i + 1, 2 * j + 1) += stretching * stretch(i, j);
          }
        problem.bounded_entries.push_back(2 * i);
        problem.upper_bounds.push_back(0.5 + 0.5 * std::cos(0.4 * i));
        problem.friction.push_back({{2 * i + 1}, {}});
        problem.right_hand_side[2 * i]     = pull * (1. + std::sin(1.7 * i));
        problem.right_hand_side[2 * i + 1] = push * std::cos(0.3 * i);
      }
    return problem;
  }

  /** A preconditioner that has nothing to say about errors. */
  class MinusIdentity : public MaskedPreconditioner
  {
  public:
    void set_mask(const Mask &) override {}
    void vmult(Vector &destination, const Vector &source) const override
    {
      destination = source;
      destination *= -1.;
    }
  };

  // Its norm of a residual is no norm: that it is below a tolerance must not count as an answer.
  TEST(TrescaMinimisation, IndefinitePreconditionersAreFound)
  {
    const auto data = random_frictional(5, 1, FrictionLaw{0.3}, 7);
    const auto solve =
      [&](const ConstrainedProblem &problem, ActiveSet &status, Vector &x, Vector &residual) {
        MinusIdentity            wrong;
        const ConstrainedProblem with_wrong{problem.matrix,
                                            wrong,
                                            problem.right_hand_side,
                                            problem.bounded_entries,
                                            problem.upper_bounds,
                                            problem.fixed_entries,
                                            problem.fixed_values,
                                            problem.tolerance,
                                            problem.bound_tolerance,
                                            problem.friction};
        return TrescaMinimisation().solve(
          with_wrong, std::vector<double>(5, 0.1), status, x, residual);
      };
    EXPECT_THROW(solve_with(solve, data, Eigen::VectorXd::Zero(12), false), StepError);
  }
} // namespace

TEST(TrescaMinimisation, ForcesOfNodesBalanceThem)
{
  unsigned int n_stick = 0, n_nodes = 0;
  for (unsigned int seed = 0; seed < 300; ++seed)
    {
      const auto plane  = random_frictional(6, 1, {0., 0.}, seed);
      const auto bounds = random_bounds(seed);
      for (const auto &problem : {plane, along_lines(plane), random_frictional(6, 2, {}, seed)})
        {
          SCOPED_TRACE("seed " + std::to_string(seed));
          const auto zero   = Eigen::VectorXd::Zero(problem.matrix.rows());
          const auto answer = minimise(problem, bounds, zero);
          n_stick += expect_minimum(problem, bounds, answer);
          n_nodes += 6;
          const auto other = minimise(problem, bounds, 3. * problem.right_hand_side);
          expect_minimum(problem, bounds, other);
          EXPECT_LT((answer.solution - other.solution).lpNorm<Eigen::Infinity>(), 1e-10);
          EXPECT_EQ(answer.status, other.status);
        }
    }
  EXPECT_TRUE(n_stick > n_nodes / 5 && n_stick < 4 * n_nodes / 5) << n_stick << " of " << n_nodes;
}

TEST(TrescaMinimisation, GuessesNextToTheKink)
{
  // One node after the other, and all of them.
  unsigned int n_stick = 0;
  for (unsigned int seed = 0; seed < 50; ++seed)
    for (const double slip : {1e-2, 1e-8, 1e-14, 1e-20, 1e-40, 1e-200})
      for (unsigned int moved = 0; moved <= 6; ++moved)
        {
          SCOPED_TRACE("seed " + std::to_string(seed) + ", node " + std::to_string(moved));
          const auto      problem = random_frictional(6, 2, {}, seed);
          const auto      bounds  = random_bounds(seed);
          const auto      zero    = Eigen::VectorXd::Zero(problem.matrix.rows());
          const auto      answer  = minimise(problem, bounds, zero);
          Eigen::VectorXd guess   = answer.solution;
          for (unsigned int k = 0; k < 6; ++k)
            if (contact_status::sticks(answer.status[k]) && (k == moved || moved == 6))
              {
                guess[3 * k + 1] += slip * std::cos(1. + seed + k);
                guess[3 * k + 2] += slip * std::sin(1. + seed + k);
              }
          const auto other = minimise(problem, bounds, guess);
          n_stick += expect_minimum(problem, bounds, other);
          EXPECT_EQ(other.status, answer.status);
        }
  EXPECT_GT(n_stick, 1000u);
}

TEST(TrescaMinimisation, StepsThatEndNextToTheKink)
{
  // Stiff coupling and a guess far away: many steps go straight to a kink, each by a part of the
  // way. One problem in 300 ended at slips of 1e-65 that counted.
  unsigned int n_stick = 0;
  for (unsigned int seed = 0; seed < 1000; ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      auto                  problem = along_lines(random_frictional(6, 1, {}, seed));
      const Eigen::MatrixXd identity =
        Eigen::MatrixXd::Identity(problem.matrix.rows(), problem.matrix.rows());
      problem.matrix = identity + 100. * (problem.matrix - identity);
      problem.right_hand_side *= 0.3;
      const auto bounds = random_bounds(seed);
      n_stick +=
        expect_minimum(problem, bounds, minimise(problem, bounds, 10. * problem.right_hand_side));
    }
  EXPECT_GT(n_stick, 1000u);
}

TEST(TrescaMinimisation, NodesThatBlockEachOther)
{
  // Where one node of a stiff strip is held the others turn about it, and meet the floor or come to
  // rest one after the other. A node that is there already must not stop all others.
  for (const double bending : {1e4, 1e7})
    for (const double stretching : {1e2, 1e4, 1e7})
      for (const double pull : {10., 1000.})
        for (const double push : {5., 50.})
          {
            const auto                problem = strip(bending, stretching, pull, push);
            const std::vector<double> bounds(problem.friction.size(), 3.);
            Eigen::VectorXd           waves(problem.matrix.rows());
            for (unsigned int i = 0; i < waves.size(); ++i)
              waves[i] = std::sin(2.3 * i);
            const auto answer = minimise(problem, bounds, 0. * waves);
            EXPECT_LE(answer.report.active_set_iterations, 30u);
            for (const double size : {1., -5.})
              {
                const auto other = minimise(problem, bounds, size * waves);
                EXPECT_LE(other.report.active_set_iterations, 30u);
                EXPECT_LT((answer.solution - other.solution).norm(), 1e-6 * answer.solution.norm());
              }
          }
}

TEST(TrescaMinimisation, TolerancesBelowRoundOff)
{
  constexpr double factor  = 1e6;
  unsigned int     n_stick = 0;
  for (unsigned int seed = 0; seed < 100; ++seed)
    for (const unsigned int n_tangents : {1, 2})
      {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto problem = random_frictional(6, n_tangents, {}, seed);
        const auto bounds  = random_bounds(seed);
        const auto zero    = Eigen::VectorXd::Zero(problem.matrix.rows());
        const auto answer  = minimise(problem, bounds, zero);
        auto       large   = problem;
        auto       larger  = bounds;
        large.right_hand_side *= factor;
        for (double &bound : large.upper_bounds)
          bound *= factor;
        for (double &bound : larger)
          bound *= factor;
        const auto same = minimise(large, larger, zero);
        EXPECT_LT((same.solution / factor - answer.solution).lpNorm<Eigen::Infinity>(), 1e-10);
        EXPECT_EQ(same.status, answer.status);
        for (const char status : answer.status)
          n_stick += contact_status::sticks(status);
      }
  EXPECT_GT(n_stick, 100u);
}
