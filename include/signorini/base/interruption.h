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

    /** @throws Interrupted on all processes if one of them was told to end. Collective. */
    void check(double time, MPI_Comm communicator) const;

  private:
    struct sigaction earlier_interrupt, earlier_terminate;
  };
} // namespace signorini

#endif
