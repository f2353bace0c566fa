// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_cap_h
#define signorini_shapes_cap_h

#include <signorini/shapes/box_shape.h>

namespace signorini
{
  /**
   * The map that makes one face of a box part of a sphere (2d: of a circle) of radius R, bulging
   * outwards. With r the distance from the line through the centre of the face along its normal, a
   * point of the face recedes by R - sqrt(R^2 - r^2) into the box; a point of the opposite face
   * stays where it is, and in between the way is linear.
   */
  template <int dim>
  class Cap
  {
  public:
    /** Of a box; with `cap_radius` zero the map does nothing. */
    explicit Cap(const BoxShape<dim> &box);

    /** Where a point of the flat box comes to lie. */
    dealii::Point<dim> bulge(const dealii::Point<dim> &point) const;
    /** Inverse of bulge(). */
    dealii::Point<dim> flatten(const dealii::Point<dim> &point) const;

    /**
     * All radii larger than this one give a cap: it reaches all edges of its face and does not
     * reach the opposite face.
     */
    double largest_invalid_radius() const;

  private:
    /** Coordinate of the capped face at the place of @p point, minus that of the opposite face. */
    double thickness_at(const dealii::Point<dim> &point) const;

    double       radius;
    unsigned int direction;     ///< coordinate along which points move
    double       opposite_face; ///< its value on the face that stays flat
    double thickness; ///< on the centre line, negative if the face looks in the negative direction
    double half_diagonal;      ///< of the face
    dealii::Point<dim> centre; ///< of the face
  };
} // namespace signorini

#endif
