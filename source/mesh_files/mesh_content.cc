// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_content.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <set>

namespace signorini
{
  std::vector<unsigned int> MeshContent::group_of(const unsigned int dim, const long number)
  {
    constexpr long largest = 999999999;
    if (number == 0)
      return {};
    if (number < 0 || number > largest)
      throw MeshFileError("a group has the number " + std::to_string(number)
                          + ". Use numbers from 1 to " + std::to_string(largest) + ".");
    const auto [group, is_new] =
      known_groups.emplace(std::array<unsigned int, 2>{{dim, static_cast<unsigned int>(number)}},
                           static_cast<unsigned int>(groups.size()));
    if (is_new)
      groups.push_back({dim, static_cast<unsigned int>(number), ""});
    return {group->second};
  }


  void MeshContent::add(const MeshElement                  &element,
                        const std::vector<unsigned int>    &nodes,
                        const std::vector<CellShape::Edge> &edges)
  {
    const std::size_t n_corners = shape_of(element.kind).n_corners;
    elements.push_back(element);
    std::copy_n(nodes.begin(), n_corners, elements.back().corners.begin());
    if (nodes.size() < n_corners + edges.size())
      return;
    for (std::size_t e = 0; e < edges.size(); ++e)
      {
        const auto [first, second] = std::minmax(nodes[edges[e].first], nodes[edges[e].second]);
        middles.emplace(CellShape::Edge(first, second), nodes[n_corners + e]);
      }
  }


  void MeshContent::number_groups()
  {
    for (unsigned int dim = 0; dim <= 3; ++dim)
      {
        std::set<unsigned int> taken;
        for (const MeshGroup &group : groups)
          if (group.dim == dim)
            taken.insert(group.number);
        unsigned int next = 1;
        for (MeshGroup &group : groups)
          if (group.dim == dim && group.number == 0)
            {
              while (!taken.insert(next).second)
                ++next;
              group.number = next;
            }
      }
  }
} // namespace signorini
