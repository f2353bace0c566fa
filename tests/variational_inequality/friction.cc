// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Contact with Coulomb friction on small dense matrices. In 2d all statuses of all nodes are tried:
// the solvers find the only solution. In 3d Newton's method and the fixed point of Tresca's
// friction end at the same point, which obeys Coulomb's law in every node, does not depend on the
// choice of the tangents, and not on the units of force and length.

#include <signorini/variational_inequality/frictional_newton.h>
#include <signorini/variational_inequality/primal_dual_active_set.h>

#include "frictional_problem.h"

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  void expect_coulomb(const FrictionalProblem &problem, const FrictionalAnswer &answer)
  {
    const Eigen::VectorXd residual = problem.right_hand_side - problem.matrix * answer.solution;
    EXPECT_LT((residual - answer.residual).lpNorm<Eigen::Infinity>(), 1e-11);
    for (unsigned int i = residual.size() - 2; i < residual.size(); ++i)
      EXPECT_NEAR(residual[i], 0., 1e-11);
    for (unsigned int k = 0; k < problem.bounded_entries.size(); ++k)
      {
        const NodeForces node = forces_at(problem, answer, k);
        const double gap   = problem.upper_bounds[k] - answer.solution[problem.bounded_entries[k]];
        const double bound = problem.friction[k].law.bound(node.normal), size = node.slip.norm();
        EXPECT_GE(gap, -1e-12) << k;
        EXPECT_GE(node.normal, -1e-11) << k;
        EXPECT_NEAR(gap * node.normal, 0., 1e-11) << k;
        EXPECT_LE(node.tangential.norm(), bound + 1e-10) << k;
        if (size > 1e-9)
          {
            EXPECT_LT((node.tangential - bound / size * node.slip).norm(), 1e-9)
              << "along the slip, node " << k;
          }
        if (contact_status::sticks(answer.status[k]))
          {
            EXPECT_EQ(size, 0.) << k;
          }
        if (contact_status::is_closed(answer.status[k]))
          {
            EXPECT_EQ(gap, 0.) << k;
          }
        else
          {
            EXPECT_NEAR(answer.residual[problem.bounded_entries[k]], 0., 1e-11) << k;
          }
      }
  }

  /** Try open, stick, slip to either side in each node (one tangent); @return all solutions. */
  std::vector<Eigen::VectorXd> brute_force(const FrictionalProblem &problem)
  {
    const unsigned int           n = problem.friction.size(), size = problem.matrix.rows();
    const double                 mu = problem.friction[0].law.coefficient;
    std::vector<Eigen::VectorXd> solutions;
    for (unsigned int code = 0; code < std::pow(4, n); ++code)
      {
        Eigen::MatrixXd  K = problem.matrix;
        Eigen::VectorXd  b = problem.right_hand_side;
        std::vector<int> what(n);
        for (unsigned int k = 0, rest = code; k < n; ++k, rest /= 4)
          {
            what[k]           = rest % 4;
            const int  normal = problem.bounded_entries[k], tangent = normal + 1;
            const auto set = [&](const int row, const double value) {
              K.row(row).setZero();
              K(row, row) = 1.;
              b[row]      = value;
            };
            if (what[k] >= 2) // t = +- mu n
              {
                const double sign = what[k] == 2 ? 1. : -1.;
                K.row(tangent) -= sign * mu * problem.matrix.row(normal);
                b[tangent] -= sign * mu * problem.right_hand_side[normal];
              }
            if (what[k] >= 1)
              set(normal, problem.upper_bounds[k]);
            if (what[k] == 1)
              set(tangent, 0.);
          }
        const Eigen::VectorXd x = K.partialPivLu().solve(b),
                              s = problem.right_hand_side - problem.matrix * x;
        bool good               = true;
        for (unsigned int k = 0; k < n; ++k)
          {
            const int normal = problem.bounded_entries[k], tangent = normal + 1;
            good = good && (what[k] == 0 ? x[normal] <= problem.upper_bounds[k] : s[normal] >= 0.);
            good = good && (what[k] != 1 || std::abs(s[tangent]) <= mu * s[normal]);
            good = good && (what[k] < 2 || (what[k] == 2 ? 1. : -1.) * x[tangent] >= 0.);
          }
        if (good)
          solutions.push_back(x);
      }
    EXPECT_EQ(problem.matrix.rows(), static_cast<int>(size));
    return solutions;
  }

  const ActiveSetLimits limits;
} // namespace

TEST(Friction, FindsTheOnlySolutionInTwoDimensions)
{
  unsigned int n_stick = 0, n_slip = 0, n_open = 0, n_iterations = 0, n_fallbacks = 0;
  for (unsigned int seed = 0; seed < 60; ++seed)
    {
      SCOPED_TRACE(seed);
      const auto problem   = random_frictional(4, 1, {0.1 + 0.01 * seed, 0.}, seed);
      const auto solutions = brute_force(problem);
      ASSERT_EQ(solutions.size(), 1u);
      FrictionalNewton newton(limits);
      TrescaFixedPoint fixed_point;
      for (const bool exact : {true, false})
        for (ConstrainedSolver *solver : {static_cast<ConstrainedSolver *>(&newton),
                                          static_cast<ConstrainedSolver *>(&fixed_point)})
          {
            SCOPED_TRACE(std::string(solver == &newton ? "Newton" : "fixed point")
                         + (exact ? "" : ", diagonal"));
            const FrictionalAnswer answer = solve(*solver, problem, exact);
            EXPECT_LT((answer.solution - solutions[0]).lpNorm<Eigen::Infinity>(), 1e-10);
            expect_coulomb(problem, answer);
          }
      const auto answer = solve(newton, problem);
      n_iterations += answer.report.active_set_iterations;
      n_fallbacks += answer.report.n_fallbacks;
      for (const char status : answer.status)
        ++(status == contact_status::stick  ? n_stick
           : status == contact_status::slip ? n_slip
                                            : n_open);
    }
  EXPECT_TRUE(n_stick > 20 && n_slip > 20 && n_open > 20)
    << n_stick << " " << n_slip << " " << n_open;
  EXPECT_LT(n_iterations, 60 * 8u);
  EXPECT_EQ(n_fallbacks, 0u);
}

TEST(Friction, SolversAgreeInThreeDimensions)
{
  unsigned int n_stick = 0, n_slip = 0, n_iterations = 0, n_fallbacks = 0;
  for (unsigned int seed = 0; seed < 60; ++seed)
    {
      SCOPED_TRACE(seed);
      const FrictionLaw law     = seed % 3 == 0   ? FrictionLaw{0.3, 0.}
                                  : seed % 3 == 1 ? FrictionLaw{0., 0.4}
                                                  : FrictionLaw{0.8, 0., 0.5};
      const auto        problem = random_frictional(5, 2, law, seed);
      FrictionalNewton  newton(limits);
      TrescaFixedPoint  fixed_point;
      const auto        answer = solve(newton, problem);
      n_iterations += answer.report.active_set_iterations;
      n_fallbacks += answer.report.n_fallbacks;
      expect_coulomb(problem, answer);
      const auto other = solve(fixed_point, problem, false);
      EXPECT_LT((answer.solution - other.solution).lpNorm<Eigen::Infinity>(), 1e-9);
      expect_coulomb(problem, other);
      EXPECT_EQ(answer.status, other.status);
      for (const char status : answer.status)
        ++(contact_status::sticks(status) ? n_stick : n_slip);
    }
  EXPECT_TRUE(n_stick > 20 && n_slip > 20) << n_stick << " " << n_slip;
  EXPECT_LT(n_iterations, 60 * 10u);
  EXPECT_EQ(n_fallbacks, 0u);
}

TEST(Friction, DoesNotDependOnTangents)
{
  const auto         problem = random_frictional(5, 2, {0.4, 0.}, 7);
  FrictionalProblem  turned  = problem;
  const unsigned int size    = problem.matrix.rows();
  Eigen::MatrixXd    Q       = Eigen::MatrixXd::Identity(size, size);
  for (unsigned int k = 0; k < 5; ++k)
    Q.block<2, 2>(3 * k + 1, 3 * k + 1) = Eigen::Rotation2Dd(0.3 + k).toRotationMatrix();
  turned.matrix          = Q.transpose() * problem.matrix * Q;
  turned.right_hand_side = Q.transpose() * problem.right_hand_side;
  FrictionalNewton solver(limits);
  const auto       answer = solve(solver, problem, true), other = solve(solver, turned, true);
  EXPECT_LT((answer.solution - Q * other.solution).lpNorm<Eigen::Infinity>(), 1e-11);
  EXPECT_EQ(answer.report.active_set_iterations, other.report.active_set_iterations);
}

TEST(Friction, WithoutCoefficientIsFrictionless)
{
  const auto          problem = random_frictional(6, 2, {0., 0.}, 3);
  FrictionalNewton    solver(limits);
  PrimalDualActiveSet frictionless({});
  FrictionalProblem   none = problem;
  none.friction.clear();
  EXPECT_LT((solve(solver, problem).solution - solve(frictionless, none).solution)
              .lpNorm<Eigen::Infinity>(),
            1e-11);
}

TEST(Friction, VeryRoughNodesAreGlued)
{
  auto             problem = random_frictional(6, 2, {1e6, 0.}, 5), glued = problem;
  FrictionalNewton solver(limits);
  const auto       answer = solve(solver, problem);
  for (unsigned int k = 0; k < 6; ++k)
    if (answer.status[k] != contact_status::open)
      {
        EXPECT_EQ(answer.status[k], contact_status::stick);
        for (const unsigned int i : problem.friction[k].entries)
          {
            glued.fixed_entries.push_back(i);
            glued.fixed_values.push_back(0.);
          }
      }
  EXPECT_GE(glued.fixed_entries.size(), 4u);
  glued.friction.clear();
  PrimalDualActiveSet frictionless({});
  EXPECT_LT((answer.solution - solve(frictionless, glued).solution).lpNorm<Eigen::Infinity>(),
            1e-11);
}

TEST(Friction, FurtherNormalForces)
{
  // Part of the bound is given, as where a projection presses, too: nodes without normal force
  // stick or slip as well. A slipping node that opens must not take its law, continued to tension,
  // for a force against the slip: one problem in a hundred then runs in circles.
  unsigned int n_fallbacks = 0, n_hang = 0, n_open = 0;
  for (const double constant : {0.01, 0.1})
    for (const unsigned int n_tangents : {1, 2})
      for (unsigned int seed = 0; seed < 300; ++seed)
        {
          SCOPED_TRACE(seed);
          auto                  problem = random_frictional(5, n_tangents, {0.8, constant}, seed);
          const Eigen::MatrixXd identity =
            Eigen::MatrixXd::Identity(problem.matrix.rows(), problem.matrix.rows());
          problem.matrix = 5. * problem.matrix - 4. * identity; // more coupling, less pressure
          for (unsigned int k = 0; k < 5; ++k)
            problem.right_hand_side[problem.bounded_entries[k]] -= 0.5;
          FrictionalNewton newton(limits);
          const auto       answer = solve(newton, problem);
          expect_coulomb(problem, answer);
          n_fallbacks += answer.report.n_fallbacks;
          n_hang += std::count(answer.status.begin(), answer.status.end(), contact_status::hang);
          n_open += std::count(answer.status.begin(), answer.status.end(), contact_status::open);
        }
  EXPECT_TRUE(n_hang > 20 && n_open > 20) << n_hang << " " << n_open;
  EXPECT_EQ(n_fallbacks, 0u);
}

TEST(Friction, SlipsWhereNeitherOpenNorStickCanBe)
{
  // Open, the node penetrates; held in all directions, it pulls; Newton's method goes to and fro.
  // With a given bound b the normal force is 0.7 - 0.8 b, so that b = 2 n overshoots, each time by
  // more than before: the fixed point must not go all the way.
  FrictionalProblem problem;
  problem.matrix       = Eigen::Matrix4d::Identity();
  problem.matrix(0, 1) = problem.matrix(1, 0) = 0.8;
  problem.right_hand_side                     = Eigen::Vector4d(-0.1, -1., 0., 0.);
  problem.bounded_entries                     = {0};
  problem.upper_bounds                        = {0.};
  problem.friction                            = {{{1}, {2., 0.}}};
  ASSERT_EQ(brute_force(problem).size(), 1u);
  FrictionalNewton newton(limits);
  TrescaFixedPoint fixed_point;
  for (ConstrainedSolver *solver :
       {static_cast<ConstrainedSolver *>(&newton), static_cast<ConstrainedSolver *>(&fixed_point)})
    {
      const auto answer = solve(*solver, problem);
      expect_coulomb(problem, answer);
      EXPECT_NEAR(answer.residual[0], 0.7 / 2.6, 1e-10);
      EXPECT_EQ(answer.status[0], contact_status::slip);
    }
}

TEST(Friction, PastSlipSetsTheDirection)
{
  // Far along a direction, the force of a closed node points along it.
  auto problem = random_frictional(4, 2, {0.5, 0.}, 2);
  for (FrictionNode &node : problem.friction)
    node.past = {6e5, 8e5};
  FrictionalNewton solver(limits);
  const auto       answer = solve(solver, problem);
  for (unsigned int k = 0; k < 4; ++k)
    {
      const NodeForces node = forces_at(problem, answer, k);
      EXPECT_LT((node.tangential - 0.5 * node.normal * Eigen::Vector2d(0.6, 0.8)).norm(), 1e-5);
    }
}

// The tolerance of a step from rest may be that of a motion that is round-off. Forces are still
// those of the solution, in held entries, too.
TEST(Friction, TolerancesBelowRoundOff)
{
  constexpr double factor = 1e12;
  for (unsigned int seed = 0; seed < 60; ++seed)
    for (const unsigned int n_tangents : {1, 2})
      {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto       problem = random_frictional(8, n_tangents, {0.3, 0.}, seed);
        auto             large   = problem;
        FrictionalNewton newton(limits);
        large.right_hand_side *= factor;
        for (double &bound : large.upper_bounds)
          bound *= factor;
        const auto            answer = solve(newton, large, false);
        const Eigen::VectorXd force  = large.right_hand_side - large.matrix * answer.solution;
        EXPECT_LT((force - answer.residual).lpNorm<Eigen::Infinity>(), 1e-12 * factor);
        EXPECT_LT((answer.solution / factor - solve(newton, problem, false).solution)
                    .lpNorm<Eigen::Infinity>(),
                  1e-10);
      }
}
