// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_provenance_h
#define signorini_output_provenance_h

#include <deal.II/base/mpi.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /**
   * Where the results of a run come from, so far as its folder does not hold it: scene and command
   * line, checksums of the meshes that it read, libraries, compiler, and machines with their
   * processors. Lines of text without the last end of line. Collective.
   * @throws RunError on all processes if a mesh has become unreadable since it was read
   */
  std::string provenance(const std::string                                      &scene_file,
                         const std::vector<std::pair<std::string, std::string>> &overrides,
                         const std::map<std::string, std::string>               &input_files,
                         MPI_Comm                                                communicator);
} // namespace signorini

#endif
