// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_face_segments_h
#define signorini_surfaces_face_segments_h

#include <signorini/surfaces/projected_face.h>

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

  /**
   * What a pair of points that face each other counts, by the cosine of the angle between the
   * normal of the slave and the opposite one of the master: 0 below `begins`, 1 above `fully`,
   * smooth between. By default 1 always.
   */
  struct FacingWeight
  {
    double begins = -2., fully = -1.;

    template <typename Number>
    Number operator()(const Number &cosine) const
    {
      const Number x = ((cosine - begins) / (fully - begins)).max(0.).min(1.);
      return x * x * (3. - 2. * x);
    }
  };

  /** The part of a slave face that one master face covers. */
  template <int dim>
  struct Segment
  {
    static constexpr int n_vertices = SurfaceFace<dim>::n_vertices;
    using OfVertices                = Eigen::Matrix<double, n_vertices, n_vertices>;
    using Vectors                   = Eigen::Matrix<double, n_vertices, dim>;

    unsigned int master = 0;  ///< index of the master face
    double       area   = 0.; ///< of the overlap, in the plane of the slave face's centre
    double       gap = 0.; ///< mean distance along the slave normal, negative behind the slave face
    double       smallest_gap = 0.; ///< at the corners of the overlap
    /**
     * Integrals with the shape functions N_i of the slave's vertices, points counted by their
     * FacingWeight.
     */
    OfVertices slave_slave  = OfVertices::Zero(); ///< int N_i N_j
    OfVertices slave_master = OfVertices::Zero(); ///< int N_i M_j, M those of the master
    Vectors    normals      = Vectors::Zero();    ///< int N_i nu
    Vectors    opposite     = Vectors::Zero();    ///< int N_i n, n that of the master
    std::vector<SegmentPoint<dim>> points;        ///< only by SegmentRule::degree_9

    bool is_empty() const { return area == 0.; }
  };

  /**
   * Finds the segments on a slave face by projection along the normal n of its centre: both faces
   * are projected on the plane there, the polygons are clipped by each other, the overlap is split
   * into triangles, and the points of their quadrature rule are mapped back to both faces (Puso and
   * Laursen 2004). The integrand is smooth on a segment: a polynomial on flat parallelograms, which
   * is integrated exactly, and close to one on other quadrilaterals.
   */
  template <int dim>
  class SegmentFinder
  {
  public:
    SegmentFinder(const SurfaceFace<dim> &slave, SegmentRule rule, const FacingWeight &facing = {});

    /** Area of the projection: the largest area of all segments. */
    double projected_area() const { return whole_area; }

    /**
     * Fill an empty segment. It stays empty if the faces do not look at each other (angle of the
     * normals) or do not overlap.
     */
    void find(const SurfaceFace<dim> &master, Segment<dim> &segment) const;

  private:
    const SurfaceFace<dim> &slave;
    const SegmentRule       rule;
    const FacingWeight      facing;
    const FacePlane<dim>    plane;
    ProjectedFace<dim>      below;
    Outline<dim>            outline;
    double                  whole_area;

    double smallest_gap(const Outline<dim> &common, const ProjectedFace<dim> &master) const;
    void   integrate(const Outline<dim>       &common,
                     const SurfaceFace<dim>   &master,
                     const ProjectedFace<dim> &master_below,
                     Segment<dim>             &segment) const;
  };

  /** One segment. */
  template <int dim>
  Segment<dim> intersect(const SurfaceFace<dim> &slave,
                         const SurfaceFace<dim> &master,
                         SegmentRule             rule = SegmentRule::degree_9);

  /** SegmentFinder::projected_area(). */
  template <int dim>
  double projected_area(const SurfaceFace<dim> &face)
  {
    return SegmentFinder<dim>(face, SegmentRule::degree_9).projected_area();
  }
} // namespace signorini

#endif
