// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/interruption.h>

#include <sstream>

namespace signorini
{
  namespace
  {
    volatile std::sig_atomic_t noted_signal = 0; ///< the latest; 0: none

    extern "C" void note_signal(const int signal)
    {
      noted_signal = signal;
    }
  } // namespace


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
