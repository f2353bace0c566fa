// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/interruption.h>

#include <sstream>

namespace signorini
{
  namespace
  {
    constexpr double       seconds_of_patience = 0.5;
    constexpr unsigned int calls_per_message   = 16;

    volatile std::sig_atomic_t noted_signal = 0; ///< the latest; 0: none

    bool         may_be_left = false; ///< the step that is being made
    unsigned int n_calls     = 0;     ///< in this step, the same on all processes
    double       noted_since = 0.;    ///< as this step knows

    extern "C" void note_signal(const int signal)
    {
      noted_signal = signal;
    }
  } // namespace


  void heed_interruption(const MPI_Comm communicator)
  {
    if (!may_be_left || ++n_calls % calls_per_message != 0)
      return;
    const double now = MPI_Wtime();
    if (noted_signal == 0)
      noted_since = now;
    const unsigned int has_waited = now - noted_since > seconds_of_patience;
    if (dealii::Utilities::MPI::max(has_waited, communicator) > 0)
      throw StepAbandoned();
  }


  Interruption::Step::Step()
  {
    may_be_left = true;
    n_calls     = 0;
    noted_since = MPI_Wtime();
  }


  Interruption::Step::~Step()
  {
    may_be_left = false;
  }


  Interruption::Interruption()
  {
    noted_signal            = 0;
    struct sigaction action = {};
    action.sa_handler       = note_signal;
    action.sa_flags         = SA_RESTART | SA_RESETHAND;
    sigaction(SIGINT, &action, &earlier_interrupt);
    sigaction(SIGTERM, &action, &earlier_terminate);
  }


  Interruption::~Interruption()
  {
    sigaction(SIGINT, &earlier_interrupt, nullptr);
    sigaction(SIGTERM, &earlier_terminate, nullptr);
  }


  bool Interruption::is_wanted(const MPI_Comm communicator)
  {
    signal = dealii::Utilities::MPI::max(static_cast<int>(noted_signal), communicator);
    return signal != 0;
  }


  void Interruption::end(const double time, const std::string &remedy) const
  {
    std::ostringstream message;
    message << "interrupted by " << (signal == SIGINT ? "SIGINT" : "SIGTERM") << " at the time "
            << time << ". " << remedy;
    throw Interrupted(message.str(), signal);
  }
} // namespace signorini
