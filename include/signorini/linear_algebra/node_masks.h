// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_node_masks_h
#define signorini_linear_algebra_node_masks_h

#include <array>
#include <vector>

namespace signorini
{
  /**
   * A local node (owned or ghost) some of whose directions are held: the orthonormal frame of the
   * node (row k: direction of its k-th entry) and which of its entries are held.
   */
  template <int dim>
  struct HeldNode
  {
    unsigned int                  node;
    std::array<double, dim * dim> frame;
    std::array<bool, dim>         held;
  };

  template <int dim>
  using HeldNodes = std::vector<HeldNode<dim>>;
} // namespace signorini

#endif
