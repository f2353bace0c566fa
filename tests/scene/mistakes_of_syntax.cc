// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Files that are no scenes, or scenes with a section too much or too little.

#include "scene_file.h"

#include <signorini/scene/output_directory.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  void expect_refusal(const std::string &text, const std::vector<std::string> &words)
  {
    const TemporaryFile file(text);
    const std::string   message = refusal(file.name);
    EXPECT_NE(message.find(file.name), std::string::npos) << message;
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos) << "`" << word << "` is not in: " << message;
  }

  std::string refusal_of_directory(const std::string &directory)
  {
    try
      {
        check_output_directory(directory);
      }
    catch (const UserError &error)
      {
        return error.what();
      }
    return "";
  }

  /** The correct scene in two dimensions without contact. */
  std::string flat_scene()
  {
    return "set Dimension = 2\n" + assignment("Time/Step size", "1e-2")
           + assignment("Time/End time", "1") + assignment("Bodies/Names", "disc")
           + assignment("Bodies/disc/Radius", "1");
  }
} // namespace

TEST(Syntax, FilesThatCannotBeRead)
{
  EXPECT_NE(refusal("no/such/scene.prm")
              .find("no/such/scene.prm: cannot read this scene: there is no such file"),
            std::string::npos);
  EXPECT_NE(refusal(testing::TempDir()).find("it is a directory"), std::string::npos);
  expect_refusal(std::string("a\0b", 3), {"not a text file"});
  expect_refusal("", {"Bodies/Names", "at least one body"});
}

TEST(Syntax, Lines)
{
  expect_refusal("subsection Time\n  set Step size = 1\n",
                 {"line 1", "`subsection Time` has no `end`", "Add"});
  expect_refusal("subsection Time\nend\nend\n", {"line 3", "`end` closes nothing", "Remove"});
  expect_refusal("\nRadius = 1\n", {"line 2", "Write `set Radius = 1`"});
  expect_refusal("\xe2\x80\xa8 set Dimension = 2\n", {"line 1", "Write `set Dimension = 2`"});
  expect_refusal("set Dimension 3\n", {"line 1", "has no value", "set key = value"});
  expect_refusal("set = 3\n", {"line 1", "names no key"});
  expect_refusal("what is this\n", {"line 1", "Valid: `set key = value`"});
  expect_refusal("set Dimension = \\\n", {"backslash"});
  expect_refusal("include nowhere.prm\n", {"line 1", "nowhere.prm", "no such file"});
}

TEST(Syntax, KeysThatAreSetTwice)
{
  const std::string first = assignment("Time/Step size", "1e-3"),
                    again = assignment("Time/Step size", "2e-3");
  expect_refusal(first + again,
                 {"line 5: Time/Step size = 2e-3: this key is set already in line 2, to 1e-3",
                  "Remove one of the two"});
  expect_refusal(first + first, {"set already in line 2"});
  // Another file may be included to be changed, and --set changes everything.
  const TemporaryFile base(flat_scene());
  const TemporaryFile changed("include " + base.name + "\n" + again);
  EXPECT_EQ(refusal(changed.name, {{"Time/Step size", "3e-3"}}), "");
}

// Some editors put the mark of the byte order in front of the first line.
TEST(Syntax, MarkOfTheByteOrder)
{
  const TemporaryFile file("\xef\xbb\xbf" + correct_scene());
  EXPECT_EQ(read_scene<3>(file.name, {}).output_directory, "output/test");
}

TEST(Syntax, MissingTimes)
{
  expect_refusal(assignment("Bodies/Names", "ball") + assignment("Bodies/ball/Radius", "1"),
                 {"Time/Step size (not given)", "is missing", "Give"});
}

TEST(Syntax, RotationInThePlaneIsOneAngle)
{
  expect_refusal(flat_scene() + assignment("Bodies/disc/Rotation", "0, 0, 10"),
                 {"Bodies/disc/Rotation = 0, 0, 10: must be one number, not 3", "one angle"});
}

TEST(Syntax, ShapesThatNeedThreeDimensions)
{
  expect_refusal(flat_scene() + assignment("Bodies/disc/Shape", "cylinder"),
                 {"cylinder", "`ball`", "`box`"});
  expect_refusal(flat_scene() + assignment("Obstacles/Names", "pillar")
                   + assignment("Obstacles/pillar/Shape", "cylinder"),
                 {"cylinder", "`sphere`"});
}

TEST(Syntax, ProbeWithoutContact)
{
  expect_refusal(flat_scene() + assignment("Probes/Names", "tip")
                   + assignment("Probes/tip/Point", "0, 1"),
                 {"Probes/tip/Point = 0, 1", "no contact pair", "Set `Body`", "remove"});
}

TEST(Syntax, SchemeWithoutContactIsFine)
{
  const TemporaryFile file(flat_scene());
  EXPECT_EQ(refusal(file.name), "");
}

TEST(OutputDirectory, IsLeftAsItWas)
{
  const std::string base = testing::TempDir() + "signorini_output_" + std::to_string(getpid());
  EXPECT_EQ(refusal_of_directory(base + "/a/b"), "");
  EXPECT_FALSE(std::filesystem::exists(base));

  std::filesystem::create_directory(base);
  EXPECT_EQ(refusal_of_directory(base), "");
  EXPECT_TRUE(std::filesystem::is_empty(base));
  std::filesystem::remove(base);
}

TEST(OutputDirectory, ThatCannotBeWritten)
{
  const TemporaryFile file("");
  const std::string   message = refusal_of_directory(file.name + "/a");
  for (const std::string word : {"Output directory = ", "is a file", "Choose another folder"})
    EXPECT_NE(message.find(word), std::string::npos) << message;
  EXPECT_NE(refusal_of_directory("/proc/signorini/a"), "");
}
