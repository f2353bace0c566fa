// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_interruption_h
#define signorini_base_interruption_h

#include <deal.II/base/mpi.h>

#include <csignal>
#include <stdexcept>
#include <string>

namespace signorini
{
  /**
   * The user wants the run to end. main() prints the message once and exits with the status that
   * shells use, 128 plus the number of the signal.
   */
  class Interrupted : public std::runtime_error
  {
  public:
    Interrupted(const std::string &message, const int signal)
      : std::runtime_error(message)
      , signal(signal)
    {
    }

    int exit_status() const { return 128 + signal; }

  private:
    int signal;
  };


  /**
   * As long as it lives, the first SIGINT (Ctrl-C) or SIGTERM is noted instead of ending the
   * program; a second one of the same kind ends it at once. One at a time.
   */
  class Interruption
  {
  public:
    Interruption();
    Interruption(const Interruption &) = delete;
    ~Interruption();

    /** Whether one of the processes was told to end: the same on all. Collective. */
    bool is_wanted(MPI_Comm communicator);

    /** @param time of the run @param remedy a sentence @throws Interrupted */
    [[noreturn]] void end(double time, const std::string &remedy) const;

  private:
    int              signal = 0; ///< that all processes know of
    struct sigaction earlier_interrupt, earlier_terminate;
  };
} // namespace signorini

#endif
