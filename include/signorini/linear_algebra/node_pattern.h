// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_node_pattern_h
#define signorini_linear_algebra_node_pattern_h

#include <signorini/base/types.h>

#include <deal.II/base/partitioner.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace signorini
{
  /**
   * Which nodes are coupled: the upper triangle, diagonal included, in compressed rows over the
   * nodes of this process. Rows and columns count local nodes, first the owned ones, then the
   * ghosts, in the order of the partitioner, which numbers dim entries per node. So the row of an
   * owned node ends with all its ghosts, and the rows of ghosts (which only overlapping
   * preconditioners need) hold the couplings among ghosts. A hanging node, which is eliminated, has
   * an empty row.
   */
  struct NodePattern
  {
    unsigned int              n_owned = 0; ///< nodes of this process
    unsigned int              n_local = 0; ///< with ghosts
    std::vector<unsigned int> row_start;   ///< n_local + 1 entries
    std::vector<unsigned int> columns; ///< ascending within a row, which begins with its diagonal
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
      partitioner; ///< of vectors with dim entries per node

    bool is_empty(const unsigned int node) const { return row_start[node] == row_start[node + 1]; }
  };


  /** Of numbers per local node, those of ghosts become what their owners have. Collective. */
  template <int dim>
  void tell_ghosts(std::vector<double> &numbers, const NodePattern &pattern)
  {
    Vector entries(pattern.partitioner);
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      entries.local_element(dim * node) = numbers[node];
    entries.update_ghost_values();
    for (unsigned int node = pattern.n_owned; node < pattern.n_local; ++node)
      numbers[node] = entries.local_element(dim * node);
  }


  /**
   * The entries of nodes, dim each, out of @p n_entries. The nodes may come in any order and more
   * than once: they are sorted first, as an IndexSet moves what it has for each range that is not
   * its last.
   */
  template <int dim>
  dealii::IndexSet entries_of_nodes(const dealii::types::global_dof_index        n_entries,
                                    std::vector<dealii::types::global_dof_index> nodes)
  {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    dealii::IndexSet entries(n_entries);
    for (const dealii::types::global_dof_index node : nodes)
      entries.add_range(dim * node, dim * (node + 1));
    entries.compress();
    return entries;
  }
} // namespace signorini

#endif
