// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/shapes/cap.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  template <int dim>
  Cap<dim>::Cap(const BoxShape<dim> &box)
    : radius(box.cap_radius)
    , direction(box.cap_boundary / 2)
    , centre(box.lower_corner + .5 * (box.upper_corner - box.lower_corner))
  {
    const bool upper              = box.cap_boundary % 2 == 1;
    centre[direction]             = (upper ? box.upper_corner : box.lower_corner)[direction];
    opposite_face                 = (upper ? box.lower_corner : box.upper_corner)[direction];
    thickness                     = centre[direction] - opposite_face;
    dealii::Point<dim> edge_point = box.lower_corner;
    edge_point[direction]         = centre[direction];
    half_diagonal                 = edge_point.distance(centre);
  }

  template <int dim>
  double Cap<dim>::thickness_at(const dealii::Point<dim> &point) const
  {
    dealii::Point<dim> projected = point;
    projected[direction]         = centre[direction];
    const double distance_square = projected.distance_square(centre);
    // R - sqrt(R^2 - r^2), without the difference of nearly equal numbers when the cap is nearly
    // flat. Quadratic cells and rounding may ask for points slightly beyond the edges.
    const double recession =
      distance_square / (radius + std::sqrt(std::max(0., radius * radius - distance_square)));
    return thickness - std::copysign(recession, thickness);
  }

  template <int dim>
  dealii::Point<dim> Cap<dim>::bulge(const dealii::Point<dim> &point) const
  {
    if (radius == 0.)
      return point;
    const double       part  = (point[direction] - opposite_face) / thickness;
    dealii::Point<dim> moved = point;
    moved[direction]         = opposite_face + part * thickness_at(point);
    return moved;
  }

  template <int dim>
  dealii::Point<dim> Cap<dim>::flatten(const dealii::Point<dim> &point) const
  {
    if (radius == 0.)
      return point;
    const double       part = (point[direction] - opposite_face) / thickness_at(point);
    dealii::Point<dim> flat = point;
    flat[direction]         = opposite_face + part * thickness;
    return flat;
  }

  template <int dim>
  double Cap<dim>::largest_invalid_radius() const
  {
    const double d = half_diagonal, h = std::abs(thickness);
    // The corners of the face recede by h if R - sqrt(R^2 - d^2) = h.
    return d <= h ? d : (d * d + h * h) / (2. * h);
  }

  template class Cap<2>;
  template class Cap<3>;
} // namespace signorini
