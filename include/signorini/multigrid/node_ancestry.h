// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_node_ancestry_h
#define signorini_multigrid_node_ancestry_h

#include <signorini/discretization/discretization.h>

namespace signorini
{
  /** A node by its number on all processes, and its weight. */
  using WeightedNode = std::pair<dealii::types::global_dof_index, double>;

  /** When a node came into being, and between which older nodes. */
  struct NodeOrigin
  {
    unsigned int level = 0; ///< of refinement; 0: a vertex of the coarse mesh
    /** Two, four or eight vertices of a refined cell with equal weights, those that hang resolved;
     * none on level 0. */
    std::vector<WeightedNode> parents;
  };

  /**
   * The origins of the owned nodes: nodes that exist up to a level are those of the mesh whose
   * cells are refined up to that level, adaptive meshes included, because a node hangs on all
   * levels or on none. Those that hang have an empty origin. Collective: vertices of refined cells
   * that are far inside other processes are asked for, a few integers each.
   */
  template <int dim>
  std::vector<NodeOrigin> node_origins(const Discretization<dim> &discretization);
} // namespace signorini

#endif
