// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_failure_h
#define signorini_base_failure_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <string>

namespace signorini
{
  /**
   * How something ended: exit status 0 (well), 1 (the run failed), 2 (a mistake of the user) or
   * 128 and more (interrupted), and why.
   */
  struct Failure
  {
    int         status = 0;
    std::string message;
  };

  /** Call a function and turn whatever it throws into a status and a message of one line. */
  Failure attempt(const std::function<void()> &action);

  /** Write the message to the standard error, in one line that is kind to terminals. */
  void report(const Failure &failure);

  /** Ends a parallel program with one message and without a process that waits for the others. */
  class FailureReporter
  {
  public:
    /**
     * Collective. The reporter needs a communicator of its own: the other may hang in the middle
     * of something.
     */
    explicit FailureReporter(MPI_Comm comm);
    FailureReporter(const FailureReporter &) = delete;
    ~FailureReporter();

    /**
     * Do something without communication on all processes, and let them agree on the result: one
     * failure is everybody's failure. Collective. @return the exit status.
     */
    int separately(const std::function<void()> &action) const;

    /**
     * Do something with communication. If all processes fail alike, one of them reports and all
     * return the exit status. If only some fail, the others wait for them for ever, so the program
     * is aborted.
     */
    int together(const std::function<void()> &action) const;

    /**
     * To be called by a process on which something with communication has failed: whether all
     * others fail, too, and come here within some seconds. If not, they may wait anywhere, and
     * nothing collective can be done any more.
     */
    bool all_fail() const;

  private:
    MPI_Comm comm;
  };
} // namespace signorini

#endif
