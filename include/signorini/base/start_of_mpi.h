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


  /** Whether no process of the run is on another machine, as far as launchers tell. */
  inline bool runs_on_one_machine()
  {
    const char *const here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
    const char *const all  = std::getenv("OMPI_COMM_WORLD_SIZE");
    return launched_rank().empty() || (here && all && std::string(here) == all);
  }


  /**
   * Before MPI starts: keep OpenMPI from what would take up to 0.4 seconds and lead to nothing.
   * What the environment sets already stays.
   */
  inline void make_mpi_start_quickly()
  {
    // Libraries of networks look for their devices, and some of them wait.
    std::error_code unknown;
    if (runs_on_one_machine())
      setenv("OMPI_MCA_mtl", "^psm2,ofi", 0);
    else if (!std::filesystem::exists("/dev/hfi1_0", unknown)) // Omni-Path
      setenv("OMPI_MCA_mtl", "^psm2", 0);
    if (!launched_rank().empty())
      return;
    // Alone: the daemon serves to start more processes, and there is nobody to send to.
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
  }
} // namespace signorini

#endif
