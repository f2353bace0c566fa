// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_spare_core_h
#define signorini_output_spare_core_h

#include <deal.II/base/mpi.h>

namespace signorini
{
  /**
   * Whether every process has a second core to itself: as far as the system lets a process choose
   * its cores, which is one of them where mpirun binds it. Processes that wait for a message keep
   * their core busy, so that a thread beside them would only be in their way. The same on all
   * processes. Collective.
   */
  bool has_spare_core(MPI_Comm communicator);
} // namespace signorini

#endif
