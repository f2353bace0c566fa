// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/polygon_clipping.h>

#include <algorithm>
#include <array>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    double cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }
  } // namespace


  double area(const Polygon &polygon)
  {
    double sum = 0.;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return sum / 2.;
  }


  Polygon clip(const Polygon &subject, const Polygon &window)
  {
    Polygon result = subject;
    for (std::size_t e = 0; e < window.size() && result.size() > 2; ++e)
      {
        const Point<2>    &start = window[e];
        const Tensor<1, 2> edge  = window[(e + 1) % window.size()] - start;
        // Distances to the left of the edge, times its length.
        std::array<double, Polygon::static_capacity> side;
        for (std::size_t i = 0; i < result.size(); ++i)
          side[i] = cross(edge, result[i] - start);
        if (std::all_of(
              side.begin(), side.begin() + result.size(), [](const double s) { return s >= 0.; }))
          continue;
        Polygon clipped;
        for (std::size_t i = 0; i < result.size(); ++i)
          {
            const std::size_t next = (i + 1) % result.size();
            if (side[i] >= 0.)
              clipped.push_back(result[i]);
            if ((side[i] > 0. && side[next] < 0.) || (side[i] < 0. && side[next] > 0.))
              clipped.push_back(result[i]
                                + side[i] / (side[i] - side[next]) * (result[next] - result[i]));
          }
        result = clipped;
      }
    return result.size() > 2 ? result : Polygon();
  }
} // namespace signorini
