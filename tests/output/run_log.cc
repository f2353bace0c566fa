// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The log holds what was said, whether or not the screen is quiet; long runs do not flood it.

#include "scratch.h"

#include <signorini/base/user_error.h>
#include <signorini/output/run_log.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace signorini;

namespace
{
  unsigned int n_lines(const std::string &text)
  {
    return std::count(text.begin(), text.end(), '\n');
  }
} // namespace

TEST(RunLog, MessagesOnce)
{
  const ScratchFolder folder;
  RunLog              log(folder.name + "/made/on/the/way", true, MPI_COMM_WORLD);
  log.message("first\nsecond");
  log.stream() << "number " << 3 << '\n';
  log.finish();
  const std::string text = contents(folder.name + "/made/on/the/way/log.txt");
  EXPECT_EQ(text.rfind("signorini ", 0), 0u) << text;
  EXPECT_EQ(text.substr(text.find('\n') + 1), "first\nsecond\nnumber 3\n");
}

TEST(RunLog, ScreenUnlessQuiet)
{
  const ScratchFolder folder;
  for (const bool quiet : {false, true})
    {
      testing::internal::CaptureStdout();
      {
        RunLog log(folder.name, quiet, MPI_COMM_WORLD);
        log.message("hello");
        log.progress(1, 1, 1., 0.1, 2., -0.01, 5);
        log.finish();
      }
      const std::string screen = testing::internal::GetCapturedStdout();
      const bool        first  = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
      if (first && !quiet)
        EXPECT_EQ(screen, contents(folder.name + "/log.txt"));
      else
        EXPECT_EQ(screen, "");
    }
}

TEST(RunLog, ProgressEveryTenth)
{
  const ScratchFolder folder;
  RunLog              log(folder.name, true, MPI_COMM_WORLD);
  for (unsigned int step = 1; step <= 1000; ++step)
    log.progress(step, 1000, 1e-3 * step, 1e-3 * step, 2.5, -0.0025, 12);
  log.finish();
  const std::string text = contents(folder.name + "/log.txt");
  // Head, first step, and ten tenths.
  EXPECT_EQ(n_lines(text), 12u) << text;
  EXPECT_NE(text.find("step 1000 of 1000"), std::string::npos);
  EXPECT_NE(text.find("energy -0.2500 %"), std::string::npos) << text;
}

TEST(RunLog, CopiesOfTheScene)
{
  const ScratchFolder folder;
  RunLog              log(folder.name, true, MPI_COMM_WORLD);
  log.copy_scene("set Dimension = 2", "set Dimension = 2\nset Output directory = x\n");
  log.finish();
  EXPECT_EQ(contents(folder.name + "/scene.prm"), "set Dimension = 2");
  EXPECT_EQ(contents(folder.name + "/parameters.prm"),
            "set Dimension = 2\nset Output directory = x\n");
}

TEST(RunLog, FullDisk)
{
  const ScratchFolder folder;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::create_symlink("/dev/full", folder.name + "/log.txt");
  MPI_Barrier(MPI_COMM_WORLD);
  RunLog log(folder.name, true, MPI_COMM_WORLD);
  log.message("this gets lost");
  EXPECT_THROW(log.finish(), RunError);
}

TEST(RunLog, FolderCannotBeMade)
{
  EXPECT_THROW(RunLog("/dev/null/results", true, MPI_COMM_WORLD), RunError);
}
