// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_interruption_h
#define signorini_base_interruption_h

#include <deal.II/base/mpi.h>

#include <csignal>
#include <exception>
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


  /** Leaves a step that is being made. The state is that of its start. */
  class StepAbandoned : public std::exception
  {
  public:
    const char *what() const noexcept override { return "a step was left because of a signal"; }
  };


  /**
   * For the iterations of solvers, which are all that a step may wait for: where a step goes on for
   * half a second after a signal, it is left. Collective; costs a message in every sixteenth call,
   * and nothing where no step is being made.
   * @throws StepAbandoned on all processes
   */
  void heed_interruption(MPI_Comm communicator);


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

    /** As long as it lives, a step is being made that may be left: see heed_interruption(). */
    class Step
    {
    public:
      Step();
      Step(const Step &) = delete;
      ~Step();
    };

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
