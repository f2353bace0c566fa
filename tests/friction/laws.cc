// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The bound of each law and its slope: proportional to the compression (Coulomb), cut off (cap),
// constant (Tresca); without compression only Tresca's is left. Scaled laws are those of scaled
// forces.

#include <signorini/friction/friction_law.h>

#include <gtest/gtest.h>

using namespace signorini;

TEST(FrictionLaw, Coulomb)
{
  const FrictionLaw law{0.3};
  EXPECT_DOUBLE_EQ(law.bound(2.), 0.6);
  EXPECT_DOUBLE_EQ(law.slope(2.), 0.3);
  EXPECT_EQ(law.bound(-1.), 0.);
  EXPECT_EQ(law.slope(-1.), 0.);
  EXPECT_TRUE(law.any());
  EXPECT_FALSE(FrictionLaw().any());
}

TEST(FrictionLaw, Cap)
{
  const FrictionLaw law{0.5, 0., 1.};
  EXPECT_DOUBLE_EQ(law.bound(1.), 0.5);
  EXPECT_EQ(law.bound(4.), 1.);
  EXPECT_EQ(law.slope(4.), 0.);
}

TEST(FrictionLaw, Tresca)
{
  const FrictionLaw law{0., 0.7};
  EXPECT_EQ(law.bound(3.), 0.7);
  EXPECT_EQ(law.bound(-3.), 0.7);
  EXPECT_EQ(law.slope(3.), 0.);
}

TEST(FrictionLaw, ScalesWithForces)
{
  const FrictionLaw law{0.4, 0.1, 0.8}, scaled = law.scaled(10.);
  for (const double force : {-1., 0.5, 3.})
    EXPECT_DOUBLE_EQ(scaled.bound(10. * force), 10. * law.bound(force));
}
