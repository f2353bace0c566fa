// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A file is there completely or not at all, and one process that fails is the failure of all.

#include "scratch.h"

#include <signorini/base/user_error.h>
#include <signorini/output/whole_file.h>

#include <deal.II/base/exceptions.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  std::string own_file(const ScratchFolder &folder)
  {
    return folder.name + "/file"
           + std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
  }
} // namespace

TEST(WholeFile, OldFileSurvivesFailure)
{
  const ScratchFolder folder;
  const std::string   path = own_file(folder);
  write_whole_file(path, [](std::ostream &out) { out << "old"; });
  EXPECT_THROW(write_whole_file(path,
                                [](std::ostream &out) {
                                  out << "half of the ne";
                                  out.setstate(std::ios::badbit);
                                }),
               RunError);
  EXPECT_EQ(contents(path), "old");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  write_whole_file(path, [](std::ostream &out) { out << "new"; });
  EXPECT_EQ(contents(path), "new");
}

TEST(WholeFile, FailureOfDealiiNamesTheFile)
{
  const ScratchFolder folder;
  const std::string   path = own_file(folder);
  try
    {
      write_whole_file(path, [](std::ostream &out) {
        out.setstate(std::ios::badbit);
        throw dealii::StandardExceptions::ExcIO();
      });
      FAIL() << "the failure was not noticed";
    }
  catch (const RunError &error)
    {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
    }
}

TEST(WholeFile, OneFailureIsEverybodysFailure)
{
  const unsigned int last = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  try
    {
      succeed_together(MPI_COMM_WORLD, [&] {
        if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == last)
          throw RunError("the last process failed");
      });
      FAIL() << "the failure was not noticed";
    }
  catch (const RunError &error)
    {
      EXPECT_STREQ(error.what(), "the last process failed");
    }
  EXPECT_NO_THROW(succeed_together(MPI_COMM_WORLD, [] {}));
}
