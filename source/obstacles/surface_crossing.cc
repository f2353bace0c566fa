// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/obstacles/box_tree.h>
#include <signorini/obstacles/surface_crossing.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double no_crossing = 1e-12; ///< volume (2d: area) over that of the surface


    /** On which side of a line c is. Twice an area. */
    double turn(const Point<2> &a, const Point<2> &b, const Point<2> &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /** On which side of a plane d is. Six times a volume. */
    double turn(const Point<3> &a, const Point<3> &b, const Point<3> &c, const Point<3> &d)
    {
      return cross_product_3d(b - a, c - a) * (d - a);
    }

    bool differ(const double one, const double other, const double zero)
    {
      return (one > zero && other < -zero) || (one < -zero && other > zero);
    }

    bool agree_in_sign(const std::array<double, 3> &numbers, const double zero)
    {
      return std::all_of(numbers.begin(), numbers.end(), [&](const double n) { return n > zero; })
             || std::all_of(
               numbers.begin(), numbers.end(), [&](const double n) { return n < -zero; });
    }


    /** Whether a segment passes through another one. */
    bool crosses(const std::array<Point<2>, 2> &one,
                 const std::array<Point<2>, 2> &other,
                 const std::array<bool, 2> &,
                 const double zero)
    {
      return differ(turn(one[0], one[1], other[0]), turn(one[0], one[1], other[1]), zero)
             && differ(turn(other[0], other[1], one[0]), turn(other[0], other[1], one[1]), zero);
    }

    /** Whether an edge of a triangle that is not at a corner of the other passes through that. */
    bool crosses(const std::array<Point<3>, 3> &one,
                 const std::array<Point<3>, 3> &other,
                 const std::array<bool, 3>     &shared,
                 const double                   zero)
    {
      const auto &[a, b, c] = other;
      for (unsigned int v = 0; v < 3; ++v)
        {
          const Point<3> &p = one[v], &q = one[(v + 1) % 3];
          if (!shared[v] && !shared[(v + 1) % 3] && differ(turn(a, b, c, p), turn(a, b, c, q), zero)
              && agree_in_sign({{turn(p, q, a, b), turn(p, q, b, c), turn(p, q, c, a)}}, zero))
            return true;
        }
      return false;
    }
  } // namespace


  template <int dim>
  void check_that_nothing_crosses(const FacetedSurface<dim> &surface)
  {
    const auto                   &facets = surface.facets();
    const double                  zero   = no_crossing * std::pow(surface.size(), dim);
    std::vector<BoundingBox<dim>> boxes;
    for (unsigned int f = 0; f < facets.size(); ++f)
      boxes.push_back(box_around(surface.corners(f)));
    const BoxTree<dim> tree(boxes);
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        const auto own   = surface.corners(f);
        double     reach = 0.;
        for (const Point<dim> &corner : own)
          reach = std::max(reach, corner.distance(boxes[f].center()));
        tree.for_each_near(boxes[f].center(), reach, [&](const unsigned int g) {
          const auto           &others = facets[g].vertices;
          std::array<bool, dim> shared;
          for (unsigned int v = 0; v < dim; ++v)
            shared[v] = std::count(others.begin(), others.end(), facets[f].vertices[v]) > 0;
          const bool shares_ridge = std::count(shared.begin(), shared.end(), true) >= dim - 1;
          if (shares_ridge || !crosses(own, surface.corners(g), shared, zero))
            return;
          std::ostringstream message;
          message << "it crosses itself near (" << boxes[f].center()
                  << "), so that nobody can say what is inside. Unite parts that overlap, or let a "
                     "mesh program repair the surface.";
          throw UserError(message.str());
        });
      }
  }

  template void check_that_nothing_crosses(const FacetedSurface<2> &);
  template void check_that_nothing_crosses(const FacetedSurface<3> &);
} // namespace signorini
