// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What `Preconditioner = automatic` takes: the diagonal where the mass rules or the matrix is used
// a few times only, multigrid where the stiffness rules and the mass still counts, the incomplete
// factor in between. The order is the one that was measured (doc/performance.md); the edges are not
// tested.

#include <signorini/preconditioners/preconditioners.h>

#include <gtest/gtest.h>

using namespace signorini;

TEST(PreconditionerChoice, FollowsTheCourantNumberOnALastingMesh)
{
  constexpr unsigned int many = 10000;
  EXPECT_EQ(choose_preconditioner(0.1, many), PreconditionerKind::jacobi);
  EXPECT_EQ(choose_preconditioner(1., many), PreconditionerKind::incomplete_cholesky);
  EXPECT_EQ(choose_preconditioner(20., many), PreconditionerKind::incomplete_cholesky);
  EXPECT_EQ(choose_preconditioner(200., many), PreconditionerKind::ml);
  EXPECT_EQ(choose_preconditioner(1e5, many), PreconditionerKind::incomplete_cholesky);
}

TEST(PreconditionerChoice, BuildsNothingForAFewSteps)
{
  EXPECT_EQ(choose_preconditioner(1., 5), PreconditionerKind::jacobi);
  EXPECT_EQ(choose_preconditioner(5., 2), PreconditionerKind::jacobi);
  EXPECT_EQ(choose_preconditioner(20., 1), PreconditionerKind::incomplete_cholesky)
    << "the diagonal is too poor there, whatever it costs";
}
