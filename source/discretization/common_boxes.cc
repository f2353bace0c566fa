// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/common_boxes.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  CommonBoxes<dim>::CommonBoxes(const unsigned int n_boxes)
    : ends(2 * dim * n_boxes, std::numeric_limits<double>::max())
  {
  }


  template <int dim>
  void CommonBoxes<dim>::add(const Point<dim> &point, const unsigned int box)
  {
    AssertIndexRange(2 * dim * box, ends.size());
    double *const lower = &ends[2 * dim * box], *const upper = lower + dim;
    for (unsigned int c = 0; c < dim; ++c)
      {
        lower[c] = std::min(lower[c], point[c]);
        upper[c] = std::min(upper[c], -point[c]);
      }
  }


  template <int dim>
  std::vector<BoundingBox<dim>> CommonBoxes<dim>::around_all(const MPI_Comm communicator) const
  {
    std::vector<double> all = ends;
    Utilities::MPI::min(ends, communicator, all);
    std::vector<BoundingBox<dim>> boxes;
    for (std::size_t first = 0; first < all.size(); first += 2 * dim)
      {
        Point<dim> lower, upper;
        for (unsigned int c = 0; c < dim; ++c)
          {
            lower[c] = all[first + c];
            upper[c] = -all[first + dim + c];
          }
        boxes.emplace_back(std::make_pair(lower, upper));
      }
    return boxes;
  }


  template class CommonBoxes<2>;
  template class CommonBoxes<3>;
} // namespace signorini
