// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_earlier_results_h
#define signorini_output_earlier_results_h

#include <deal.II/base/mpi.h>

#include <string>

namespace signorini
{
  /**
   * Remove what an earlier run left in an output directory (tables, fields, pictures of ours), so
   * that nothing old stands beside the new results. Other files stay. Collective.
   */
  void remove_earlier_results(const std::string &directory, MPI_Comm communicator);
} // namespace signorini

#endif
