// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_face_segments_h
#define signorini_surfaces_face_segments_h

#include <signorini/surfaces/surface_face.h>

namespace signorini
{
  /**
   * A quadrature point on two opposite faces: the points lie on one line along the normal of the
   * slave face's centre.
   */
  template <int dim>
  struct SegmentPoint
  {
    dealii::Point<dim - 1> slave, master; ///< reference coordinates on both faces
    double                 weight;        ///< times the surface element of the slave face
    dealii::Tensor<1, dim> normal,
      opposite;                   ///< of slave and master, unit vectors out of the bodies
    dealii::Tensor<1, dim> apart; ///< from the point of the slave to that of the master
  };

  /**
   * The rule on each triangle of a segment, by the degree of the polynomials that it integrates
   * exactly (Witherden and Vincent 2015); in 2d one rule is exact for all flat faces. Degree 4 is
   * enough for parallelograms; more serves other quadrilaterals, whose shape functions are no
   * polynomials in space.
   */
  enum class SegmentRule
  {
    degree_5, ///< for what is made anew again and again
    degree_9
  };

  /** The part of a slave face that one master face covers. */
  template <int dim>
  struct Segment
  {
    unsigned int master = 0;  ///< index of the master face
    double       area   = 0.; ///< of the overlap, in the plane of the slave face's centre
    double       gap = 0.; ///< mean distance along the slave normal, negative behind the slave face
    double       smallest_gap = 0.; ///< at the corners of the overlap
    std::vector<SegmentPoint<dim>> points;
  };

  /**
   * The segment of two faces by projection along the normal n of the slave face's centre: both are
   * projected on the plane there, the polygons are clipped by each other, the overlap is split into
   * triangles, and the points of their quadrature rule are mapped back to both faces (Puso and
   * Laursen 2004). The integrand is smooth on a segment: a polynomial on flat parallelograms, which
   * is integrated exactly, and close to one on other quadrilaterals.
   * @return a segment without points if the faces do not look at each other (angle of the normals)
   *         or do not overlap
   */
  template <int dim>
  Segment<dim> intersect(const SurfaceFace<dim> &slave,
                         const SurfaceFace<dim> &master,
                         SegmentRule             rule = SegmentRule::degree_9);

  /** Area of the projection of a face on the plane of its centre: the largest area of its segments.
   */
  template <int dim>
  double projected_area(const SurfaceFace<dim> &face);
} // namespace signorini

#endif
