// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What `Preconditioner = automatic` takes: the diagonal where the mass rules or the matrix is used
// a few times only, multigrid where the stiffness rules, the earlier the larger the mesh, the
// incomplete factor in between. The order is the one that was measured (doc/performance.md); the
// edges are not tested.

#include <signorini/preconditioners/preconditioners.h>

#include <gtest/gtest.h>

using namespace signorini;

TEST(PreconditionerChoice, FollowsTheCourantNumberOnALastingMesh)
{
  constexpr unsigned int many = 10000, dofs = 100000;
  EXPECT_EQ(choose_preconditioner(0.1, dofs, many), PreconditionerKind::jacobi);
  EXPECT_EQ(choose_preconditioner(1., dofs, many), PreconditionerKind::incomplete_cholesky);
  EXPECT_EQ(choose_preconditioner(5., dofs, many), PreconditionerKind::incomplete_cholesky);
  EXPECT_EQ(choose_preconditioner(40., dofs, many), PreconditionerKind::multigrid);
  EXPECT_EQ(choose_preconditioner(1e5, dofs, many), PreconditionerKind::multigrid);
}

TEST(PreconditionerChoice, TakesMultigridLaterOnASmallMesh)
{
  constexpr unsigned int many = 10000, dofs = 3000;
  EXPECT_EQ(choose_preconditioner(40., dofs, many), PreconditionerKind::incomplete_cholesky);
  EXPECT_EQ(choose_preconditioner(200., dofs, many), PreconditionerKind::multigrid);
}

TEST(PreconditionerChoice, BuildsNothingForAFewSteps)
{
  constexpr unsigned int dofs = 100000;
  EXPECT_EQ(choose_preconditioner(1., dofs, 5), PreconditionerKind::jacobi);
  EXPECT_EQ(choose_preconditioner(5., dofs, 2), PreconditionerKind::jacobi);
  EXPECT_EQ(choose_preconditioner(20., dofs, 1), PreconditionerKind::multigrid)
    << "the diagonal is too poor there, whatever it costs";
}
