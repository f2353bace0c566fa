// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/closest_point.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim, std::size_t n>
    ClosestPoint<dim, n> with_weights(const std::array<Point<dim>, n> &corners,
                                      const std::array<double, n>     &weights)
    {
      // From the corner that counts most, so that a corner is met to the last digit.
      const std::size_t first = std::max_element(weights.begin(), weights.end()) - weights.begin();
      ClosestPoint<dim, n> result{corners[first], weights};
      for (std::size_t v = 0; v < n; ++v)
        if (v != first)
          result.foot += weights[v] * (corners[v] - corners[first]);
      return result;
    }
  } // namespace


  template <int dim>
  ClosestPoint<dim, 2> closest_point(const Point<dim> &p, const std::array<Point<dim>, 2> &corners)
  {
    const Tensor<1, dim> along  = corners[1] - corners[0];
    const double         before = (p - corners[0]) * along, behind = (corners[1] - p) * along;
    if (before <= 0.)
      return with_weights<dim, 2>(corners, {{1., 0.}});
    if (behind <= 0.)
      return with_weights<dim, 2>(corners, {{0., 1.}});
    const double length = before + behind;
    return with_weights<dim, 2>(corners, {{behind / length, before / length}});
  }


  ClosestPoint<3, 3> closest_point(const Point<3> &p, const std::array<Point<3>, 3> &corners)
  {
    const Tensor<1, 3> ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const auto         weights = [&](const double a, const double b, const double c) {
      return with_weights<3, 3>(corners, {{a, b, c}});
    };
    const double d1 = ab * (p - corners[0]), d2 = ac * (p - corners[0]);
    if (d1 <= 0. && d2 <= 0.)
      return weights(1., 0., 0.);
    const double d3 = ab * (p - corners[1]), d4 = ac * (p - corners[1]);
    if (d3 >= 0. && d4 <= d3)
      return weights(0., 1., 0.);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0. && d1 >= 0. && d3 <= 0.)
      return weights(-d3 / (d1 - d3), d1 / (d1 - d3), 0.);
    const double d5 = ab * (p - corners[2]), d6 = ac * (p - corners[2]);
    if (d6 >= 0. && d5 <= d6)
      return weights(0., 0., 1.);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0. && d2 >= 0. && d6 <= 0.)
      return weights(-d6 / (d2 - d6), 0., d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0. && d4 >= d3 && d5 >= d6)
      {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return weights(0., 1. - w, w);
      }
    const double sum = va + vb + vc;
    return weights(va / sum, vb / sum, vc / sum);
  }


  template ClosestPoint<2, 2> closest_point(const Point<2> &, const std::array<Point<2>, 2> &);
  template ClosestPoint<3, 2> closest_point(const Point<3> &, const std::array<Point<3>, 2> &);
} // namespace signorini
