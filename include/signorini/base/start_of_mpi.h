// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_start_of_mpi_h
#define signorini_base_start_of_mpi_h

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace signorini
{
  /** The rank in a run that a launcher has started, before MPI knows; empty: started alone. */
  inline std::string launched_rank()
  {
    for (const char *name :
         {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "MPI_LOCALRANKID", "SLURM_PROCID"})
      if (const char *rank = std::getenv(name))
        return rank;
    return "";
  }


  /**
   * Before MPI starts: keep OpenMPI from what would take a fifth of a second and lead to nothing.
   * What is set already stays.
   */
  inline void make_mpi_start_quickly()
  {
    // The driver of Omni-Path waits for its device.
    std::error_code unknown;
    if (!std::filesystem::exists("/dev/hfi1_0", unknown))
      setenv("OMPI_MCA_mtl", "^psm2", 0);
    if (!launched_rank().empty())
      return;
    // Alone: the daemon serves to start more processes, and there is nobody to send to.
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
  }
} // namespace signorini

#endif
