// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The measures of oscillation have the values that their definitions give for simple sequences: one
// hump counts 1, a zigzag of amplitude a counts a, and smooth motion counts nothing.

#include <signorini/diagnostics/oscillation.h>

#include <gtest/gtest.h>

#include <vector>

using namespace signorini;

namespace
{
  double variation(const std::vector<double> &values)
  {
    TotalVariation result;
    for (const double value : values)
      result.add(value);
    return result.measure();
  }

  double zigzag(const std::vector<double> &values)
  {
    Zigzag result;
    for (const double value : values)
      result.add(value, true);
    return result.amplitude();
  }
} // namespace

TEST(TotalVariation, CountsHumps)
{
  EXPECT_DOUBLE_EQ(variation({0., 1., 3., 7., 7., 2., 0.}), 1.);
  EXPECT_DOUBLE_EQ(variation({5., 0.}), 1.) << "the sequence starts from zero";
  EXPECT_DOUBLE_EQ(variation({0., 2., 0., 2., 0., 2., 0.}), 3.);
  EXPECT_DOUBLE_EQ(variation({0., 4., 3., 4., 0.}), 1.25);
  EXPECT_DOUBLE_EQ(variation({1., 2.}), 0.5) << "not come down yet";
}

TEST(TotalVariation, OfNothingIsZero)
{
  EXPECT_EQ(variation({}), 0.);
  EXPECT_EQ(variation({0., 0.}), 0.);
}

TEST(TotalVariation, KnowsTheMaximum)
{
  TotalVariation result;
  for (const double value : {1., 7., 3.})
    result.add(value);
  EXPECT_EQ(result.largest(), 7.);
}

TEST(Zigzag, HasItsAmplitude)
{
  EXPECT_DOUBLE_EQ(zigzag({2., -2., 2., -2., 2.}), 2.);
  EXPECT_DOUBLE_EQ(zigzag({2., 0., 2., 0., 2.}), 1.) << "an offset does not matter";
}

TEST(Zigzag, OfAStraightLineIsZero)
{
  EXPECT_EQ(zigzag({1., 2., 3., 4.}), 0.);
  EXPECT_EQ(zigzag({}), 0.);
  EXPECT_EQ(zigzag({3., -7.}), 0.) << "two values are no zigzag";
}

TEST(Zigzag, JudgesOnlyWhatCounts)
{
  Zigzag result;
  for (const double value : {1., -1., 1., -1.})
    result.add(value, false);
  EXPECT_EQ(result.amplitude(), 0.);
  result.add(3., true); // 3 - 2 (-1) + 1 = 6
  EXPECT_DOUBLE_EQ(result.amplitude(), 1.5);
}
