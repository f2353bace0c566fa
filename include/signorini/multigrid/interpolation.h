// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_interpolation_h
#define signorini_multigrid_interpolation_h

#include <signorini/discretization/local_nodes.h>
#include <signorini/multigrid/node_ancestry.h>

namespace signorini
{
  /**
   * How the nodes of a level follow those of the next coarser one: a node that both have follows
   * itself, a new one the vertices between which it was born.
   */
  class Interpolation
  {
  public:
    struct Part
    {
      unsigned int node; ///< local, of the coarse level
      float        weight;
    };

    /** @param parents of each local fine node, by global coarse numbers; coarse: the owned nodes */
    Interpolation(const std::vector<std::vector<WeightedNode>> &parents, LocalNodes coarse);

    /** Owned nodes of the coarse level, and those of others that local fine nodes follow. */
    const LocalNodes &coarse() const { return coarse_nodes; }

    unsigned int n_fine() const { return starts.size() - 1; }

    dealii::ArrayView<const Part> parts(const unsigned int fine_node) const
    {
      return {parts_of_all.data() + starts[fine_node], starts[fine_node + 1] - starts[fine_node]};
    }

  private:
    LocalNodes                coarse_nodes;
    std::vector<unsigned int> starts;
    std::vector<Part>         parts_of_all;
  };
} // namespace signorini

#endif
