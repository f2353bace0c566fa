// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/spare_core.h>

#include <thread>

namespace signorini
{
  bool has_spare_core(const MPI_Comm communicator)
  {
    namespace Communication = dealii::Utilities::MPI;
    MPI_Comm on_this_machine;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &on_this_machine);
    const unsigned int n_processes = Communication::n_mpi_processes(on_this_machine);
    MPI_Comm_free(&on_this_machine);
    const bool here = 2 * n_processes <= std::thread::hardware_concurrency();
    return Communication::min(here ? 1 : 0, communicator) == 1;
  }
} // namespace signorini
