// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What the method takes to be small is said once, when it is no longer small, with the time, the
// name and the remedy, and again at the end with the largest value. The rotation of a body is that
// of its displacement, whatever the body's strain, translation and place, and the largest strain is
// that of the body itself.

#include "../discretization/bodies.h"

#include <signorini/diagnostics/body_motion.h>
#include <signorini/diagnostics/validity.h>
#include <signorini/finite_elements/largest_strains.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  ValidityReading reading(const double time, const double rotation, const double sliding)
  {
    return {time, {0., 0.}, {0., rotation}, {}, {sliding}};
  }

  void expect_parts(const std::string &text, const std::vector<std::string> &parts)
  {
    for (const std::string &part : parts)
      EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }

  /** A ball and a box, far from the origin. */
  Scene<3> two_bodies()
  {
    BodyDescription<3> round = ball<3>(1), flat = box<3>();
    ball_of(round).centre     = dealii::Point<3>(100., -30., 7.);
    box_of(flat).lower_corner = dealii::Point<3>(-3., 0., 0.);
    box_of(flat).upper_corner = dealii::Point<3>(-2., 2., 0.5);
    return scene_of<3>({round, flat});
  }
} // namespace

TEST(Validity, SaysWhatBeginsOnceAndTheLargestAtTheEnd)
{
  Validity validity({"ball", "anvil"}, {"ball : anvil"});
  EXPECT_TRUE(validity.judge(reading(0.1, 0.04, 0.9)).empty());
  const auto news = validity.judge(reading(0.2, 0.06, 0.9));
  ASSERT_EQ(news.size(), 1u);
  expect_parts(news[0], {"at time 0.2", "'anvil'", "3.44 degrees", "end the run earlier"});
  ASSERT_EQ(validity.judge(reading(0.3, 0.2, 1.5)).size(), 1u) << "only the sliding is new";
  EXPECT_TRUE(validity.judge(reading(0.4, 0.01, 0.)).empty());
  const auto summary = validity.summary();
  ASSERT_EQ(summary.size(), 2u);
  expect_parts(summary[0], {"since time 0.2", "'anvil'", "11.5 degrees"});
  expect_parts(summary[1], {"since time 0.3", "'ball : anvil'", "1.5 times"});
}

// Two bodies that turn need one sentence about what follows from it, not two.
TEST(Validity, AdviceIsGivenOnceInTheRunAndOnceAtItsEnd)
{
  Validity    validity({"ball", "anvil"}, {});
  std::string said;
  for (const double angle : {0.06, 0.1})
    for (const std::string &news : validity.judge({angle, {}, {angle, 0.6 * angle}, {}, {}}))
      said += news + "\n";
  expect_parts(said, {"at time 0.06 the body 'ball'", "at time 0.1 the body 'anvil'"});
  const std::string advice = "end the run earlier";
  EXPECT_LT(said.find(advice), said.find("'anvil'"));
  EXPECT_EQ(said.find(advice), said.rfind(advice)) << said;
  const auto summary = validity.summary();
  ASSERT_EQ(summary.size(), 1u);
  expect_parts(summary[0],
               {"since time 0.06 the body 'ball' is 5.73 degrees turned",
                "since time 0.1 the body 'anvil' is 3.44 degrees turned",
                advice});
  EXPECT_EQ(summary[0].find(advice), summary[0].rfind(advice)) << summary[0];
}

// What helps depends on the scheme, which this module does not know.
TEST(Validity, RemedyOfLinearisedContactIsThatOfTheScene)
{
  Validity validity({"ball"}, {"ball : anvil"}, false, "", "take another");
  for (const std::string &news : validity.judge({1., {0.02}, {0.}, {0.}, {2.}}))
    expect_parts(news, {"Let contact follow the motion: take another."});
  EXPECT_EQ(validity.summary().size(), 2u);
}

TEST(Validity, DepthAndStrain)
{
  Validity validity({"ball"}, {});
  EXPECT_TRUE(validity.judge({1., {0.009}, {0.}, {0.049}, {}}).empty());
  const auto news = validity.judge({2., {0.011}, {0.}, {0.051}, {}});
  ASSERT_EQ(news.size(), 2u);
  expect_parts(news[0], {"'ball' is 1.1 % of its size deep", "linearised"});
  expect_parts(news[1], {"'ball' is 5.1 % strained", "Hooke"});
}

TEST(Validity, NormalsThatTurnInContact)
{
  Validity        validity({"ball"}, {}, true, "better");
  ValidityReading now = reading(0.5, 0., 0.);
  now.turning         = {0.05};
  EXPECT_TRUE(validity.judge(now).empty());
  now.turning     = {0.06};
  const auto news = validity.judge(now);
  ASSERT_EQ(news.size(), 1u);
  expect_parts(news[0],
               {"at time 0.5", "'ball' is 3.44 degrees round", "Take `Time/Scheme = better`"});
}

TEST(BodyMotion, RotationIsThatOfTheBodyItself)
{
  const Assembled<3>  assembled(two_bodies());
  const BodyMotion<3> motion(assembled.discretization);
  // A rotation by (0.1, -0.2, 0.2) about some point with a strain that is symmetric in the shape of
  // the bodies, and a translation.
  const Vector u = assembled.discretization.interpolate(
    {{{"-0.2*z - 0.2*y + 0.01*(x - 100) + 5", "0.2*x - 0.1*z", "0.1*y + 0.2*x"}},
     {{"0.3 + 0.01*x", "-0.02*y", "7"}}});
  const auto angles = motion.rotation(u);
  ASSERT_EQ(angles.size(), 2u);
  EXPECT_NEAR(angles[0], 0.3, 1e-12);
  EXPECT_NEAR(angles[1], 0., 1e-12);
}

TEST(BodyMotion, InThePlane)
{
  BodyDescription<2> body = box_with_hanging_nodes<2>();
  const Assembled<2> assembled(body);
  const Vector       u = field<2>(assembled.discretization, {{"-0.07*y + 3", "0.07*x"}});
  EXPECT_NEAR(BodyMotion<2>(assembled.discretization).rotation(u)[0], 0.07, 1e-13);
}

TEST(LargestStrains, OfTheBodyItself)
{
  const Assembled<3> assembled(two_bodies());
  const Vector       u = assembled.discretization.interpolate(
    {{{"0.1*y", "0.1*x", "0"}}, {{"-0.2*z", "0.02*y", "0.2*x - 0.05*z"}}});
  const auto strains = largest_strains(assembled.discretization, u);
  ASSERT_EQ(strains.size(), 2u);
  EXPECT_NEAR(strains[0], 0.1, 1e-12) << "shear has the principal strains 0.1 and -0.1";
  EXPECT_NEAR(strains[1], 0.05, 1e-12) << "the rotation has none";
}
