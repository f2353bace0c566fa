// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Solvers that go on and on are left soon after a signal, by all processes in the same iteration,
// although one of them alone has heard of it. What is no step is not left.

#include <signorini/base/interruption.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using namespace signorini;

namespace
{
  const MPI_Comm everybody = MPI_COMM_WORLD;

  void tell_last_process()
  {
    if (dealii::Utilities::MPI::this_mpi_process(everybody) + 1
        == dealii::Utilities::MPI::n_mpi_processes(everybody))
      std::raise(SIGTERM);
  }


  /** @return the iteration that was not begun any more */
  unsigned int iterate(const unsigned int most)
  {
    for (unsigned int iteration = 0; iteration < most; ++iteration)
      try
        {
          heed_interruption(everybody);
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
      catch (const StepAbandoned &)
        {
          return iteration;
        }
    return most;
  }
} // namespace

TEST(Interruption, LeavesAStepThatTakesLong)
{
  Interruption interruption;
  tell_last_process();
  unsigned int left = 0;
  {
    const Interruption::Step step;
    left = iterate(5000);
  }
  EXPECT_GT(left, 0u);
  EXPECT_LT(left, 5000u); // ten seconds, twenty times what is waited for
  EXPECT_EQ(dealii::Utilities::MPI::min(left, everybody),
            dealii::Utilities::MPI::max(left, everybody));
  EXPECT_TRUE(interruption.is_wanted(everybody));
  EXPECT_THROW(interruption.end(0.5, "Go on."), Interrupted);
}

TEST(Interruption, LeavesNothingElse)
{
  Interruption interruption;
  {
    const Interruption::Step step; // no signal
    EXPECT_EQ(iterate(400), 400u);
  }
  tell_last_process();
  EXPECT_EQ(iterate(400), 400u); // no step
  EXPECT_TRUE(interruption.is_wanted(everybody));
}
