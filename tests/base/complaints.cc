// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What processes complain about becomes one error that all of them throw, also those that found
// nothing wrong: the worst one, among equals the first in the alphabet, whoever has it.

#include <signorini/base/complaints.h>
#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  /** What is thrown if one process has all of the complaints and the others have none. */
  std::string thrown(const std::vector<Complaint> &complaints, const unsigned int process)
  {
    const bool has_them = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == process;
    try
      {
        throw_worst(has_them ? complaints : std::vector<Complaint>(), MPI_COMM_WORLD);
      }
    catch (const UserError &error)
      {
        return error.what();
      }
    return "nothing";
  }

  unsigned int last_process()
  {
    return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  }
} // namespace

TEST(Complaints, NoneIsNoError)
{
  EXPECT_NO_THROW(throw_worst({}, MPI_COMM_WORLD));
}

TEST(Complaints, EveryProcessThrowsTheWorst)
{
  for (const unsigned int process : {0u, last_process()})
    {
      EXPECT_EQ(thrown({{0., "a"}}, process), "a"); // not bad at all, but a complaint
      EXPECT_EQ(thrown({{1., "a"}, {3., "c"}, {2., "b"}}, process), "c");
      EXPECT_EQ(thrown({{3., "a"}, {3., "c"}, {3., "b"}}, process), "a");
    }
}

TEST(Complaints, OfSeveralProcessesAreCompared)
{
  const unsigned int process = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const auto         message = [&](const double growth) {
    try
      {
        throw_worst({{growth * process, "of process " + std::to_string(process)}}, MPI_COMM_WORLD);
      }
    catch (const UserError &error)
      {
        return std::string(error.what());
      }
    return std::string("nothing");
  };
  EXPECT_EQ(message(1.), "of process " + std::to_string(last_process()));
  EXPECT_EQ(message(-1.), "of process 0");
  EXPECT_EQ(message(0.), "of process 0");
}
