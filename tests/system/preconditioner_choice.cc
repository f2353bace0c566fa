// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What `Preconditioner = automatic` takes. Where sweeps solve by themselves: those, until they take
// too many iterations. Else: the diagonal where the mass rules or the matrix is used a few times
// only, multigrid where the stiffness rules, the earlier the larger the mesh, the incomplete factor
// in between. The order is the one that was measured (doc/performance.md); the edges are not
// tested.

#include <signorini/preconditioners/preconditioner_choice.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  /** On processes that share the contact of two bodies. */
  PreconditionerKind
  of_factors(const double courant_number, const unsigned int n_dofs, const unsigned int life_time)
  {
    return choose_preconditioner({courant_number, n_dofs, life_time});
  }

  PreconditionerKind
  of_sweeps(const double courant_number, const double iterations, const bool with_friction = false)
  {
    StepCost cost{courant_number, 100000, 100, 1., true, iterations, with_friction};
    cost.effective_courant_number = courant_number;
    return choose_preconditioner(cost);
  }
} // namespace

TEST(PreconditionerChoice, FollowsTheCourantNumberOnALastingMesh)
{
  constexpr unsigned int many = 10000, dofs = 100000;
  EXPECT_EQ(of_factors(0.1, dofs, many), PreconditionerKind::jacobi);
  EXPECT_EQ(of_factors(1., dofs, many), PreconditionerKind::incomplete_cholesky);
  EXPECT_EQ(of_factors(5., dofs, many), PreconditionerKind::incomplete_cholesky);
  EXPECT_EQ(of_factors(40., dofs, many), PreconditionerKind::multigrid);
  EXPECT_EQ(of_factors(1e5, dofs, many), PreconditionerKind::multigrid);
}

TEST(PreconditionerChoice, TakesMultigridLaterOnASmallMesh)
{
  constexpr unsigned int many = 10000, dofs = 3000;
  EXPECT_EQ(of_factors(40., dofs, many), PreconditionerKind::incomplete_cholesky);
  EXPECT_EQ(of_factors(200., dofs, many), PreconditionerKind::multigrid);
}

TEST(PreconditionerChoice, BuildsNothingForAFewSteps)
{
  constexpr unsigned int dofs = 100000;
  EXPECT_EQ(of_factors(1., dofs, 5), PreconditionerKind::jacobi);
  EXPECT_EQ(of_factors(5., dofs, 2), PreconditionerKind::jacobi);
  EXPECT_EQ(of_factors(20., dofs, 1), PreconditionerKind::multigrid)
    << "the diagonal is too poor there, whatever it costs";
}

TEST(PreconditionerChoice, SweepsUntilTheyTakeTooManyIterations)
{
  EXPECT_EQ(of_sweeps(0.1, 0.), PreconditionerKind::symmetric_gauss_seidel);
  EXPECT_EQ(of_sweeps(10., 0.), PreconditionerKind::symmetric_gauss_seidel);
  EXPECT_EQ(of_sweeps(1000., 0.), PreconditionerKind::multigrid) << "as long as nothing is known";
  EXPECT_EQ(of_sweeps(10., 80.), PreconditionerKind::multigrid);
  EXPECT_EQ(of_sweeps(1000., 10.), PreconditionerKind::symmetric_gauss_seidel);
  EXPECT_EQ(of_sweeps(10., 25.), PreconditionerKind::symmetric_gauss_seidel);
  EXPECT_EQ(of_sweeps(10., 25., true), PreconditionerKind::multigrid)
    << "with friction there are more linear systems, and each asks for less";
}

TEST(PreconditionerChoice, SweepsWhereFewCellsAreSmall)
{
  StepCost cost{1000., 100000, 10000};
  cost.effective_courant_number = 30.;
  EXPECT_EQ(choose_preconditioner(cost), PreconditionerKind::multigrid)
    << "nobody would look at the iterations of the factor";
  cost.solves_roughly = true;
  EXPECT_EQ(choose_preconditioner(cost), PreconditionerKind::symmetric_gauss_seidel);
}

TEST(PreconditionerChoice, SweepsForLongerOnAGradedMesh)
{
  StepCost cost{70., 100000, 10000};
  cost.effective_courant_number = 70.;
  cost.solves_roughly           = true;
  EXPECT_EQ(choose_preconditioner(cost), PreconditionerKind::multigrid);
  cost.iterations = 40.;
  EXPECT_EQ(choose_preconditioner(cost), PreconditionerKind::multigrid);
  cost.grading = 0.6;
  EXPECT_EQ(choose_preconditioner(cost), PreconditionerKind::symmetric_gauss_seidel);
  cost.iterations = 0.;
  EXPECT_EQ(choose_preconditioner(cost), PreconditionerKind::symmetric_gauss_seidel);
}

TEST(PreconditionerChoice, KeepsMultigridFromBodiesThatDifferTooMuch)
{
  StepCost cost{1000., 100000, 10000, 1e7};
  EXPECT_EQ(choose_preconditioner(cost), PreconditionerKind::incomplete_cholesky);
  cost.solves_roughly = true;
  cost.iterations     = 80.;
  EXPECT_EQ(choose_preconditioner(cost), PreconditionerKind::incomplete_cholesky);
}
