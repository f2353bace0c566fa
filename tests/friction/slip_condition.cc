// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The linearised law of a slipping node. At a point of the law (force of the size of the bound,
// along the slip) it gives this force, and its derivatives are those of b(n) s/|s|, by differences.
// Away from the law a few Newton iterations with given slip and normal force lead there.

#include <signorini/friction/slip_condition.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;

namespace
{
  TangentVector law_of(const FrictionLaw &law, const TangentVector &slip, const double normal)
  {
    return law.bound(normal) / slip.norm() * slip;
  }
} // namespace

TEST(SlipCondition, IsTheDerivativeOfTheLaw)
{
  const double h = 1e-6;
  for (const FrictionLaw &law :
       {FrictionLaw{0.3}, FrictionLaw{0., 0.5}, FrictionLaw{0.3, 0., 0.4}, FrictionLaw{0.3, 0.1}})
    for (const double stiffness : {0.1, 3.})
      {
        const TangentVector slip(0.2, -0.3);
        const double        normal = 2.;
        const auto          condition =
          linearise_slip(law, {normal, law_of(law, slip, normal), slip}, stiffness, 2);
        EXPECT_LT((condition.force - law_of(law, slip, normal)).norm(), 1e-14);
        for (unsigned int j = 0; j < 2; ++j)
          {
            const TangentVector step = h * TangentVector::Unit(j);
            const TangentVector difference =
              (law_of(law, slip + step, normal) - law_of(law, slip - step, normal)) / (2. * h);
            EXPECT_LT((condition.stiffness.col(j) - difference).norm(), 1e-8);
          }
        const TangentVector difference =
          (law_of(law, slip, normal + h) - law_of(law, slip, normal - h)) / (2. * h);
        EXPECT_LT((condition.coupling - difference).norm(), 1e-8);
      }
}

TEST(SlipCondition, LeadsToTheLaw)
{
  const FrictionLaw   law{0.3};
  const TangentVector slip(0.2, -0.3), expected = law_of(law, slip, 2.);
  for (unsigned int k = 0; k < 16;
       ++k) // forces of all directions and several sizes, opposite to the slip, too
    {
      TangentVector force = (0.2 + 0.1 * k) * TangentVector(std::cos(0.4 * k), std::sin(0.4 * k));
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        force = linearise_slip(law, {2., force, slip}, 1., 2).force;
      EXPECT_LT((force - expected).norm(), 1e-10) << k;
    }
}

TEST(SlipCondition, DoesNotTurnWithOneTangent)
{
  const auto condition = linearise_slip({0.3}, {2., {0.1, 0.}, {-4., 0.}}, 1., 1);
  EXPECT_EQ(condition.stiffness, TangentMatrix::Zero());
  EXPECT_EQ(condition.force, TangentVector(-0.6, 0.));
  EXPECT_EQ(condition.coupling, TangentVector(-0.3, 0.));
}

TEST(SlipCondition, DoesNotDependOnTheAxes)
{
  const double        angle = 0.7;
  const TangentMatrix R{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
  const NodeForces    node{2., {0.1, 0.5}, {-0.4, 0.7}};
  const auto          condition = linearise_slip({0.3}, node, 1., 2),
             turned = linearise_slip({0.3}, {2., R * node.tangential, R * node.slip}, 1., 2);
  EXPECT_LT((turned.force - R * condition.force).norm(), 1e-14);
  EXPECT_LT((turned.coupling - R * condition.coupling).norm(), 1e-14);
  EXPECT_LT((turned.stiffness - R * condition.stiffness * R.transpose()).norm(), 1e-14);
}

TEST(SlipCondition, DecidesWhoSticks)
{
  const FrictionLaw law{0.5};
  EXPECT_TRUE(sticks(law, {2., {0.3, 0.9}, {0., 0.}}, 1.)) << "force below the bound";
  EXPECT_FALSE(sticks(law, {2., {0.8, 0.9}, {0., 0.}}, 1.)) << "force beyond the bound";
  EXPECT_FALSE(sticks(law, {2., {0.6, 0.8}, {3., 4.}}, 1.)) << "slip along the force";
  EXPECT_TRUE(sticks(law, {2., {0.6, 0.8}, {-30., -40.}}, 1.)) << "slip against the force";
  SlipHistory turns;
  turns.stops_first = false;
  EXPECT_FALSE(sticks(law, {2., {0.6, 0.8}, {-30., -40.}}, 1., turns)) << "it need not stop";
  EXPECT_TRUE(sticks(law, {2., {0.6, 0.8}, {-0.6, -0.8}}, 1., turns)) << "below the bound";
  EXPECT_FALSE(sticks(law, {0., {0., 0.}, {0., 0.}}, 1.)) << "no normal force, no friction";
}

// At the bound, but for what solvers leave open, a node remains what it was.
TEST(SlipCondition, GoesOnAtTheBound)
{
  const FrictionLaw law{0.5};
  const NodeForces above{2., {0.6, 0.8 + 1e-11}, {0., 0.}}, below{2., {0.6, 0.8 - 1e-11}, {0., 0.}},
    back{2., {0.6, 0.8}, {0., -1e-11}}, far{2., {0.6, 0.8 + 1e-7}, {0., 0.}};
  SlipHistory stuck, slipped;
  stuck.has_stuck     = true;
  slipped.has_slipped = true;
  EXPECT_FALSE(sticks(law, above, 1.));
  EXPECT_TRUE(sticks(law, above, 1., stuck));
  EXPECT_FALSE(sticks(law, far, 1., stuck));
  EXPECT_TRUE(sticks(law, below, 1.));
  EXPECT_FALSE(sticks(law, below, 1., slipped));
  EXPECT_TRUE(sticks(law, {2., {0.6, 0.7}, {0., 0.}}, 1., slipped));
  EXPECT_TRUE(sticks(law, back, 1.));
  EXPECT_FALSE(sticks(law, back, 1., slipped));
}

TEST(SlipCondition, ForceIsOnTheCone)
{
  const NodeForces    node{4., {0.1, 0.1}, {-3., 4.}};
  const TangentVector force = slip_force({0.5}, node, 1e17);
  EXPECT_LT((force - TangentVector(-1.2, 1.6)).norm(), 1e-15);
  // A slip that is less than what the solver resolves has no direction of its own.
  const TangentVector hardly = slip_force({0.5}, {4., {1.2, -1.6}, {0., 1e-14}}, 0.04);
  EXPECT_LT((hardly - TangentVector(1.2, -1.6)).norm(), 1e-14);
  EXPECT_NEAR(slip_force({0.5}, {4., {1., -1.5}, {0.3, 0.2}}, 2.).norm(), 2., 1e-15);
}
