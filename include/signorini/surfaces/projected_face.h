// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_projected_face_h
#define signorini_surfaces_projected_face_h

#include <signorini/surfaces/polygon_clipping.h>
#include <signorini/surfaces/surface_face.h>

#include <Eigen/Core>

namespace signorini
{
  /** Values at a few points at once, one per lane of the processor's registers. */
  template <int dim>
  using AtPoints = Eigen::Array<double, dim == 2 ? 4 : 8, 1>;

  template <int dim>
  using LanePoint = std::array<AtPoints<dim>, dim - 1>; ///< in a plane, or on a face

  template <int dim>
  using LaneShapes = std::array<AtPoints<dim>, SurfaceFace<dim>::n_vertices>;

  /** Ends of an interval, ascending, or a polygon. */
  template <int dim>
  using Outline =
    std::conditional_t<dim == 2, boost::container::static_vector<dealii::Point<1>, 2>, Polygon>;


  /** The auxiliary plane: through the centre of a slave face, across its normal there. */
  template <int dim>
  struct FacePlane
  {
    explicit FacePlane(const SurfaceFace<dim> &face);

    dealii::Point<dim - 1> project(const dealii::Tensor<1, dim> &from_origin) const
    {
      dealii::Point<dim - 1> result;
      for (unsigned int d = 0; d < dim - 1; ++d)
        result[d] = axes[d] * from_origin;
      return result;
    }

    dealii::Point<dim>                          origin;
    dealii::Tensor<1, dim>                      normal;
    std::array<dealii::Tensor<1, dim>, dim - 1> axes;
  };


  /** A face seen in the plane: its projected vertices, and the way back from there. */
  template <int dim>
  class ProjectedFace
  {
  public:
    ProjectedFace(const SurfaceFace<dim> &face, const FacePlane<dim> &plane);

    /** Counterclockwise (2d: two ascending coordinates). */
    Outline<dim> outline() const;

    /** False if boxes around both are apart, or touch only. */
    bool may_overlap(const ProjectedFace &other) const;

    /** What map_back(), area_vector() need beyond the outline. */
    void prepare(const SurfaceFace<dim> &face);

    /**
     * The reference coordinates of the points of the face that lie over points of the plane: by
     * Newton's method, which needs one step on a parallelogram.
     */
    LanePoint<dim> map_back(const LanePoint<dim> &target) const;

    static LaneShapes<dim> shape_values(const LanePoint<dim> &xi);

    /** Over the plane. */
    AtPoints<dim> height(const LaneShapes<dim> &shapes) const
    {
      AtPoints<dim> result = shapes[0] * heights[0];
      for (unsigned int v = 1; v < SurfaceFace<dim>::n_vertices; ++v)
        result += shapes[v] * heights[v];
      return result;
    }

    /** As SurfaceFace::area_vector(): linear in the reference coordinates. */
    std::array<AtPoints<dim>, dim> area_vector(const LanePoint<dim> &xi) const;

    dealii::Tensor<1, dim> area_vector_at_centre() const;

  private:
    static constexpr unsigned int n_vertices = SurfaceFace<dim>::n_vertices;

    std::array<dealii::Point<dim - 1>, n_vertices> vertices;
    std::array<double, n_vertices>                 heights;
    dealii::Point<dim - 1>                         lower, upper; ///< of the box around it
    std::array<dealii::Tensor<1, dim>, dim>        area_parts;   ///< constant, times xi_0, xi_1
    /** The face is vertices[0] plus these times xi_0, xi_1 and xi_0 xi_1 (2d: xi_0, none). */
    std::array<dealii::Tensor<1, dim - 1>, dim> edges;
    /**
     * After a change of (c_0, c_1) Newton's method in map_back() misses at most this times |c_0
     * c_1|: zero on parallelograms.
     */
    double remainder = 0.;
  };
} // namespace signorini

#endif
