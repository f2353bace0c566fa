// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Processes agree on a failure, also when it happens on one of them only.

#include <signorini/base/failure.h>
#include <signorini/base/user_error.h>

#include <deal.II/base/exceptions.h>

#include <gtest/gtest.h>

#include <new>

using namespace signorini;

namespace
{
  const MPI_Comm comm = MPI_COMM_WORLD;

  bool is_last()
  {
    return dealii::Utilities::MPI::this_mpi_process(comm) + 1
           == dealii::Utilities::MPI::n_mpi_processes(comm);
  }
} // namespace

TEST(Failure, StatusAndMessage)
{
  EXPECT_EQ(attempt([] {}).status, 0);
  const Failure mistake = attempt([] { throw UserError("a.prm: wrong"); });
  EXPECT_EQ(mistake.status, 2);
  EXPECT_EQ(mistake.message, "a.prm: wrong");
  EXPECT_EQ(attempt([] { throw RunError("no convergence"); }).status, 1);
  EXPECT_NE(attempt([] { throw std::bad_alloc(); }).message.find("out of memory"),
            std::string::npos);
  EXPECT_EQ(attempt([] { throw 1; }).status, 1);
}

TEST(Failure, UsefulPartOfAnExceptionOfDealII)
{
  const Failure failure =
    attempt([] { AssertThrow(false, dealii::ExcMessage("the matrix is singular")); });
  EXPECT_EQ(failure.status, 1);
  EXPECT_EQ(failure.message, "the run failed: the matrix is singular");
}

// A message quotes the input. Whatever that is, the message is one line of readable length, with
// its beginning and its end.
TEST(Failure, IsOneLineOfReadableLength)
{
  const FailureReporter reporter(comm);
  testing::internal::CaptureStderr();
  reporter.separately(
    [] { throw UserError("a.prm: " + std::string(1000000, 'v') + "\n\r\x1b: correct it."); });
  const std::string message = testing::internal::GetCapturedStderr();
  if (dealii::Utilities::MPI::this_mpi_process(comm) != 0)
    return;
  EXPECT_LT(message.size(), 3000u);
  EXPECT_EQ(message.rfind("signorini: a.prm: vvv", 0), 0u);
  EXPECT_NE(message.find("   : correct it.\n"), std::string::npos);
  EXPECT_EQ(message.find('\n'), message.size() - 1);
}

TEST(Failure, OfOneProcessIsThatOfAll)
{
  const FailureReporter reporter(comm);
  EXPECT_EQ(reporter.separately([] {}), 0);
  EXPECT_EQ(reporter.separately([] {
    if (is_last())
      throw UserError("on one process");
  }),
            2);
}

TEST(Failure, OfAllProcessesDoesNotAbort)
{
  const FailureReporter reporter(comm);
  EXPECT_EQ(reporter.together([] {}), 0);
  EXPECT_EQ(reporter.together([] { throw RunError("on all processes"); }), 1);
}

// What is wrong with a scene is found by modules that do not know its file.
TEST(Failure, NamesTheFileOfAMistake)
{
  const auto find = [](const bool is_mistake) {
    return attempt([&] {
      naming_file<UserError>("a.prm", [&] {
        if (is_mistake)
          throw UserError("Time/Mass: wrong");
        throw RunError("disk full");
      });
    });
  };
  EXPECT_EQ(find(true).message, "a.prm: Time/Mass: wrong");
  EXPECT_EQ(find(true).status, 2);
  EXPECT_EQ(find(false).message.find("a.prm"), std::string::npos) << "not the fault of the file";
  EXPECT_EQ(naming_file<UserError>("a.prm", [] { return 3; }), 3);
}
