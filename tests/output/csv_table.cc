// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Numbers come back from a table without loss; a table that cannot be written is an error on every
// process.

#include "scratch.h"

#include <signorini/base/user_error.h>
#include <signorini/output/csv_table.h>

#include <gtest/gtest.h>

#include <cstdlib>

using namespace signorini;

TEST(CsvTable, ReadsBackWithoutLoss)
{
  const ScratchFolder       folder;
  const std::string         path   = folder.name + "/table.csv";
  const std::vector<double> values = {1. / 3., -2.5e-300, 6.02214076e23, 0.1};
  CsvTable                  table(path, {"a", "b", "c", "d"}, MPI_COMM_WORLD);
  table.write_row(values);

  // The table is still open: what was written is on the disk all the same.
  std::istringstream lines(contents(path));
  std::string        line, number;
  std::getline(lines, line);
  EXPECT_EQ(line, "a,b,c,d");
  std::getline(lines, line);
  std::istringstream row(line);
  for (const double value : values)
    {
      ASSERT_TRUE(std::getline(row, number, ','));
      EXPECT_EQ(std::strtod(number.c_str(), nullptr), value);
    }
  EXPECT_FALSE(std::getline(row, number, ','));
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(CsvTable, WholeNumbersAreIntegers)
{
  const ScratchFolder folder;
  const std::string   path = folder.name + "/table.csv";
  CsvTable            table(path, {"step", "dofs", "zero"}, MPI_COMM_WORLD);
  table.write_row({12., 697827000., 0.});
  EXPECT_EQ(contents(path), "step,dofs,zero\n12,697827000,0\n");
}

TEST(CsvTable, FullDisk)
{
  try
    {
      CsvTable("/dev/full", {"a"}, MPI_COMM_WORLD).write_row({1.});
      FAIL() << "a full disk was not noticed";
    }
  catch (const RunError &error)
    {
      EXPECT_NE(std::string(error.what()).find("/dev/full"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
    }
}

TEST(CsvTable, FolderThatIsNotThere)
{
  const ScratchFolder folder;
  CsvTable            table(folder.name + "/nowhere/table.csv", {"a"}, MPI_COMM_WORLD);
  EXPECT_THROW(table.write_row({1.}), RunError);
}

TEST(CsvTable, RowOfWrongLength)
{
  const ScratchFolder folder;
  CsvTable            table(folder.name + "/table.csv", {"a", "b"}, MPI_COMM_WORLD);
  EXPECT_THROW(table.write_row({1.}), RunError);
}
