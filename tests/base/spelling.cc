// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Distances between words, and the suggestions that follow from them.

#include <signorini/base/spelling.h>

#include <gtest/gtest.h>

using namespace signorini;

TEST(Spelling, Distance)
{
  EXPECT_EQ(edit_distance("", "ball"), 4u);
  EXPECT_EQ(edit_distance("ball", "ball"), 0u);
  EXPECT_EQ(edit_distance("Ball", "bal"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(Spelling, Suggestion)
{
  const std::vector<std::string> shapes = {"ball", "box", "cylinder"};
  EXPECT_EQ(nearest("Cylindre", shapes), "cylinder");
  EXPECT_EQ(nearest("hexagon", shapes), "");
  EXPECT_EQ(suggestion("bal", shapes), "Did you mean `ball`? Valid: ball, box, cylinder.");
  EXPECT_EQ(suggestion("hexagon", shapes), "Valid: ball, box, cylinder.");
}

TEST(Spelling, Words)
{
  EXPECT_EQ(trim("  a \t b  "), "a b");
  EXPECT_EQ(split(" a ;; b", ';'), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(join({"a", "b"}, "/"), "a/b");
  EXPECT_EQ(enumeration({"a"}, " and "), "a");
  EXPECT_EQ(enumeration({"a", "b"}, " and "), "a and b");
  EXPECT_EQ(enumeration({"a", "b", "c"}, ", or "), "a, b, or c");
  EXPECT_TRUE(consists_of("121", "12"));
  EXPECT_FALSE(consists_of("123", "12"));
  EXPECT_FALSE(consists_of("", "12"));
  EXPECT_TRUE(is_name("a-B_3"));
  EXPECT_FALSE(is_name("a b"));
}

TEST(Spelling, PartsHaveTwoDigitsAndNoneBeyondTheWhole)
{
  EXPECT_EQ(about_per_cent(0.034567), "about 3.5 %");
  EXPECT_EQ(about_per_cent(0.), "about 0 %");
  EXPECT_EQ(about_per_cent(5.8e3), "more than 100 %");
}
