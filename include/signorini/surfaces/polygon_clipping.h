// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_polygon_clipping_h
#define signorini_surfaces_polygon_clipping_h

#include <deal.II/base/point.h>

#include <boost/container/static_vector.hpp>

namespace signorini
{
  /**
   * Vertices in counterclockwise order. There is room for what two quadrilaterals have in common,
   * also if they are not convex.
   */
  using Polygon = boost::container::static_vector<dealii::Point<2>, 16>;

  /** Signed area, positive for counterclockwise order. */
  double area(const Polygon &polygon);

  /**
   * Intersection of two convex polygons (Sutherland and Hodgman 1974); empty if they have no
   * common interior.
   */
  Polygon clip(const Polygon &subject, const Polygon &window);
} // namespace signorini

#endif
