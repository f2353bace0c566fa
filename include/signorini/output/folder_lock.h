// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_folder_lock_h
#define signorini_output_folder_lock_h

#include <deal.II/base/mpi.h>

#include <string>

namespace signorini
{
  /**
   * Two runs that write to one folder would mix their tables. As long as it lives no other run
   * begins there; a lock ends with its process, however that ends. File systems without locks are
   * not guarded.
   */
  class FolderLock
  {
  public:
    /**
     * Makes the folder, and waits some seconds for a run that is about to end. Collective.
     * @throws RunError on all processes if another run goes on writing there
     */
    FolderLock(const std::string &directory, MPI_Comm communicator);
    FolderLock(const FolderLock &) = delete;
    ~FolderLock();

  private:
    int file = -1; ///< descriptor, on the first process
  };
} // namespace signorini

#endif
