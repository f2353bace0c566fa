// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_node_blocks_h
#define signorini_multigrid_node_blocks_h

#include <signorini/multigrid/level_vector.h>

#include <Eigen/Core>

#include <map>

namespace signorini
{
  /** A small matrix for each of some nodes, by local number: owned, or a ghost. */
  template <int dim>
  using NodeBlocks = std::map<unsigned int, Eigen::Matrix<double, dim, dim>>;

  /** Add the blocks of ghosts to those of their owners, and forget them. Collective. */
  template <int dim>
  void add_to_owners(NodeBlocks<dim> &blocks, const GhostValues &ghosts)
  {
    if (ghosts.is_alone())
      return;
    NodeBlocks<dim>     sums;
    LevelVector<double> columns;
    for (unsigned int j = 0; j < dim; ++j)
      {
        columns.resize(0);
        columns.resize(4 * ghosts.n_owned_nodes());
        ghosts.clear<double>();
        for (const auto &[node, block] : blocks)
          {
            Lanes<double> column{};
            for (unsigned int i = 0; i < dim; ++i)
              column[i] = block(i, j);
            ghosts.add(columns, node, column);
          }
        ghosts.add_to_owners(columns);
        for (unsigned int node = 0; node < ghosts.n_owned_nodes(); ++node)
          for (unsigned int i = 0; i < dim; ++i)
            if (columns[4 * node + i] != 0.)
              sums.try_emplace(node, Eigen::Matrix<double, dim, dim>::Zero()).first->second(i, j) =
                columns[4 * node + i];
      }
    blocks = std::move(sums);
  }
} // namespace signorini

#endif
