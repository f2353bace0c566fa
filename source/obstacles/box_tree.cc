// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/box_tree.h>

#include <algorithm>
#include <numeric>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int most_in_leaf = 4;
  } // namespace


  template <int dim>
  BoxTree<dim>::BoxTree(const std::vector<BoundingBox<dim>> &boxes)
    : things(boxes.size())
  {
    std::iota(things.begin(), things.end(), 0u);
    if (!boxes.empty())
      grow(boxes, 0, boxes.size());
  }


  template <int dim>
  void BoxTree<dim>::grow(const std::vector<BoundingBox<dim>> &boxes,
                          const unsigned int                   first,
                          const unsigned int                   end)
  {
    BoundingBox<dim> all = boxes[things[first]];
    for (unsigned int k = first + 1; k < end; ++k)
      all.merge_with(boxes[things[k]]);
    const auto         corners = all.get_boundary_points();
    const unsigned int branch  = branches.size();
    branches.push_back({corners.first, corners.second, first, end, 0});
    if (end - first <= most_in_leaf)
      return;
    unsigned int longest = 0;
    for (unsigned int c = 1; c < dim; ++c)
      if (all.side_length(c) > all.side_length(longest))
        longest = c;
    const unsigned int middle = (first + end) / 2;
    std::nth_element(things.begin() + first,
                     things.begin() + middle,
                     things.begin() + end,
                     [&](const unsigned int a, const unsigned int b) {
                       return boxes[a].center()[longest] < boxes[b].center()[longest];
                     });
    grow(boxes, first, middle);
    branches[branch].second = branches.size();
    grow(boxes, middle, end);
  }


  template class BoxTree<2>;
  template class BoxTree<3>;
} // namespace signorini
