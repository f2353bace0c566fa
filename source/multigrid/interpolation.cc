// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/interpolation.h>

namespace signorini
{
  Interpolation::Interpolation(const std::vector<std::vector<WeightedNode>> &parents,
                               LocalNodes                                    coarse)
    : coarse_nodes(std::move(coarse))
    , starts(1, 0)
  {
    coarse_nodes.ghosts.clear();
    for (const auto &of_node : parents)
      for (const auto &[node, weight] : of_node)
        if (!coarse_nodes.owns(node))
          coarse_nodes.ghosts.push_back(node);
    coarse_nodes.sort_ghosts();
    for (const auto &of_node : parents)
      {
        for (const auto &[node, weight] : of_node)
          parts_of_all.push_back({coarse_nodes.local(node), static_cast<float>(weight)});
        starts.push_back(parts_of_all.size());
      }
  }
} // namespace signorini
