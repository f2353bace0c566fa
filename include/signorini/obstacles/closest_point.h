// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_closest_point_h
#define signorini_obstacles_closest_point_h

#include <deal.II/base/point.h>

#include <array>

namespace signorini
{
  /** The point of a simplex that is closest to another point. */
  template <int dim, std::size_t n>
  struct ClosestPoint
  {
    dealii::Point<dim>    foot;
    std::array<double, n> weights; ///< of the corners; exactly 0 where the foot is on the boundary
  };

  /** Of a segment. */
  template <int dim>
  ClosestPoint<dim, 2> closest_point(const dealii::Point<dim>                &p,
                                     const std::array<dealii::Point<dim>, 2> &corners);

  /**
   * Of a triangle: C. Ericson, Real-Time Collision Detection (2005), section 5.1.5: the regions of
   * corners, edges and the face are told apart by the signs of products alone.
   */
  ClosestPoint<3, 3> closest_point(const dealii::Point<3>                &p,
                                   const std::array<dealii::Point<3>, 3> &corners);

  /** Of a point. */
  template <int dim>
  ClosestPoint<dim, 1> closest_point(const dealii::Point<dim> &,
                                     const std::array<dealii::Point<dim>, 1> &corners)
  {
    return {corners[0], {{1.}}};
  }
} // namespace signorini

#endif
