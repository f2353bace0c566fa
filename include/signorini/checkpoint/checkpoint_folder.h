// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_checkpoint_checkpoint_folder_h
#define signorini_checkpoint_checkpoint_folder_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace signorini
{
  /**
   * The checkpoints of a run, in its output directory: `checkpoint`, the latest, and
   * `checkpoint.previous`, the one before it. A new one is written to `checkpoint.part` and takes
   * its place when it is complete, so that one is whole at any instant. Its `manifest` names the
   * version of the program and, for each file, length and checksum. All functions are collective.
   */
  class CheckpointFolder
  {
  public:
    CheckpointFolder(const std::string &output_directory, MPI_Comm communicator);

    /**
     * A new checkpoint. @param write_files into the given folder @throws RunError on all processes;
     * the earlier ones are whole then
     */
    void write(const std::function<void(const std::string &folder)> &write_files) const;

    /** What was found, and why nothing better. */
    struct Found
    {
      std::string              folder;   ///< of the latest checkpoint that is whole; or empty
      std::vector<std::string> rejected; ///< what is wrong with later ones, a sentence each
    };

    Found find() const;

    /** Those of an earlier run are of no use any more. */
    void remove() const;

  private:
    const std::string directory;
    const MPI_Comm    communicator;
    const bool        first_process;
  };
} // namespace signorini

#endif
