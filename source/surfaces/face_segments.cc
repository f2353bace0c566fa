// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/contact_frame.h>
#include <signorini/surfaces/face_segments.h>
#include <signorini/surfaces/polygon_clipping.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** The auxiliary plane: through the centre of the slave face, across its normal there. */
    template <int dim>
    struct FacePlane
    {
      Point<dim>                          origin;
      Tensor<1, dim>                      normal;
      std::array<Tensor<1, dim>, dim - 1> axes;

      explicit FacePlane(const SurfaceFace<dim> &face)
        : origin(face.centre())
        , normal(face.unit_normal())
      {
        const auto frame = contact_frame<dim>(normal);
        for (unsigned int d = 0; d < dim - 1; ++d)
          for (unsigned int c = 0; c < dim; ++c)
            axes[d][c] = frame[dim * (d + 1) + c];
      }

      Point<dim - 1> project(const Tensor<1, dim> &from_origin) const
      {
        Point<dim - 1> result;
        for (unsigned int d = 0; d < dim - 1; ++d)
          result[d] = axes[d] * from_origin;
        return result;
      }
    };


    /** A face seen in the plane: its projected vertices, and the way back from there. */
    template <int dim>
    class ProjectedFace
    {
    public:
      ProjectedFace(const SurfaceFace<dim> &face, const FacePlane<dim> &plane)
      {
        for (unsigned int v = 0; v < face.n_vertices; ++v)
          vertices[v] = plane.project(face.vertices[v] - plane.origin);
      }

      /** Counterclockwise (2d: two ascending coordinates). */
      std::vector<Point<dim - 1>> outline() const
      {
        std::vector<Point<dim - 1>> points(vertices.begin(), vertices.end());
        if constexpr (dim == 2)
          {
            if (points[1][0] < points[0][0])
              std::swap(points[0], points[1]);
          }
        else
          {
            std::swap(points[2], points[3]); // lexicographic to circular
            if (area(points) < 0.)
              std::reverse(points.begin(), points.end());
          }
        return points;
      }

      /**
       * The reference coordinates of the point of the face that lies over a point of the plane: by
       * Newton's method, which needs one step on a parallelogram.
       */
      Point<dim - 1> map_back(const Point<dim - 1> &target) const
      {
        if constexpr (dim == 2)
          return Point<1>((target[0] - vertices[0][0]) / (vertices[1][0] - vertices[0][0]));
        else
          {
            const Tensor<1, 2> a = vertices[1] - vertices[0], b = vertices[2] - vertices[0],
                               bend = vertices[3] - vertices[2] - a;
            Point<2> xi             = SurfaceFace<3>::middle();
            for (unsigned int iteration = 0; iteration < 20; ++iteration)
              {
                const Tensor<1, 2> defect = (target - vertices[0]) - xi[0] * a - xi[1] * b
                                            - xi[0] * xi[1] * bend,
                                   s = a + xi[1] * bend, t = b + xi[0] * bend;
                const double       determinant = s[0] * t[1] - s[1] * t[0];
                const Tensor<1, 2> change({(defect[0] * t[1] - defect[1] * t[0]) / determinant,
                                           (s[0] * defect[1] - s[1] * defect[0]) / determinant});
                xi += change;
                if (change.norm() < 1e-14)
                  break;
              }
            return xi;
          }
      }

    private:
      std::array<Point<dim - 1>, SurfaceFace<dim>::n_vertices> vertices;
    };


    double measure(const std::vector<Point<1>> &interval)
    {
      return interval.empty() ? 0. : interval[1][0] - interval[0][0];
    }
    double measure(const Polygon &polygon)
    {
      return area(polygon);
    }

    std::vector<Point<1>> overlap(const std::vector<Point<1>> &a, const std::vector<Point<1>> &b)
    {
      const double lower = std::max(a[0][0], b[0][0]), upper = std::min(a[1][0], b[1][0]);
      return lower < upper ? std::vector<Point<1>>{Point<1>(lower), Point<1>(upper)}
                           : std::vector<Point<1>>();
    }

    Polygon overlap(const Polygon &a, const Polygon &b)
    {
      for (unsigned int d = 0; d < 2; ++d)
        {
          const auto less     = [d](const Point<2> &p, const Point<2> &q) { return p[d] < q[d]; };
          const auto [a0, a1] = std::minmax_element(a.begin(), a.end(), less);
          const auto [b0, b1] = std::minmax_element(b.begin(), b.end(), less);
          if ((*a1)[d] <= (*b0)[d] || (*b1)[d] <= (*a0)[d])
            return {};
        }
      return clip(a, b);
    }


    /** Points and weights on an interval, exact for the products of linear functions. */
    std::vector<std::pair<Point<1>, double>> quadrature(const std::vector<Point<1>> &interval,
                                                        SegmentRule)
    {
      static const QGauss<1>                   rule(3);
      const double                             length = measure(interval);
      std::vector<std::pair<Point<1>, double>> result;
      for (unsigned int q = 0; q < rule.size(); ++q)
        result.emplace_back(interval[0] + length * Tensor<1, 1>(rule.point(q)),
                            length * rule.weight(q));
      return result;
    }


    /**
     * Points and weights on a polygon, on each triangle of a fan: around its centre, which is more
     * accurate on other quadrilaterals than parallelograms, or from a corner, which needs fewer.
     */
    std::vector<std::pair<Point<2>, double>> quadrature(const Polygon    &polygon,
                                                        const SegmentRule wanted)
    {
      static const QWitherdenVincentSimplex<2> degree_5(3), degree_9(5);
      const bool                               from_corner = wanted == SegmentRule::degree_5;
      const auto                              &rule        = from_corner ? degree_5 : degree_9;
      std::vector<std::pair<Point<2>, double>> result;
      result.reserve(polygon.size() * rule.size());
      Point<2> apex = polygon[0];
      if (!from_corner)
        {
          apex = Point<2>();
          for (const Point<2> &p : polygon)
            apex += p / static_cast<double>(polygon.size());
        }
      for (std::size_t i = 0; i < polygon.size(); ++i)
        {
          const Tensor<1, 2> a = polygon[i] - apex, b = polygon[(i + 1) % polygon.size()] - apex;
          const double       jacobian = a[0] * b[1] - a[1] * b[0];
          for (unsigned int q = 0; q < rule.size() && jacobian > 0.; ++q)
            result.emplace_back(apex + rule.point(q)[0] * a + rule.point(q)[1] * b,
                                jacobian * rule.weight(q));
        }
      return result;
    }
  } // namespace


  template <int dim>
  Segment<dim>
  intersect(const SurfaceFace<dim> &slave, const SurfaceFace<dim> &master, const SegmentRule rule)
  {
    Segment<dim>         segment;
    const FacePlane<dim> plane(slave);
    // Beyond 84 degrees faces do not look at each other; a projection would be distorted without
    // bound.
    if (master.unit_normal() * plane.normal > -0.1)
      return segment;

    const ProjectedFace<dim> slave_below(slave, plane), master_below(master, plane);
    const auto               slave_outline = slave_below.outline();
    const auto               common        = overlap(slave_outline, master_below.outline());
    segment.area                           = measure(common);
    if (!(segment.area > 1e-12 * measure(slave_outline)))
      return segment;

    segment.smallest_gap = std::numeric_limits<double>::max();
    for (const Point<dim - 1> &corner : common)
      segment.smallest_gap = std::min(segment.smallest_gap,
                                      plane.normal
                                        * (master.position(master_below.map_back(corner))
                                           - slave.position(slave_below.map_back(corner))));
    const auto points = quadrature(common, rule);
    segment.points.reserve(points.size());
    for (const auto &[point, weight] : points)
      {
        const Point<dim - 1> xi = slave_below.map_back(point), eta = master_below.map_back(point);
        const Tensor<1, dim> normal = slave.unit_normal(xi),
                             apart  = master.position(eta) - slave.position(xi);
        segment.points.push_back(
          {xi, eta, weight / (normal * plane.normal), normal, master.unit_normal(eta), apart});
        segment.gap += weight / segment.area * (plane.normal * apart);
      }
    return segment;
  }


  template <int dim>
  double projected_area(const SurfaceFace<dim> &face)
  {
    return measure(ProjectedFace<dim>(face, FacePlane<dim>(face)).outline());
  }


  template Segment<2> intersect(const SurfaceFace<2> &, const SurfaceFace<2> &, SegmentRule);
  template Segment<3> intersect(const SurfaceFace<3> &, const SurfaceFace<3> &, SegmentRule);
  template double     projected_area(const SurfaceFace<2> &);
  template double     projected_area(const SurfaceFace<3> &);
} // namespace signorini
