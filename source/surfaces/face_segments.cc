// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/face_segments.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Points and weights of a quadrature rule, lanes that are left over repeat the first point. */
    template <int dim>
    struct LaneRule
    {
      std::vector<LanePoint<dim>> points;
      std::vector<AtPoints<dim>>  weights;

      explicit LaneRule(const Quadrature<dim - 1> &rule)
      {
        constexpr unsigned int n_lanes = AtPoints<dim>::RowsAtCompileTime;
        for (unsigned int first = 0; first < rule.size(); first += n_lanes)
          {
            LanePoint<dim> lane_points;
            AtPoints<dim>  lane_weights;
            for (unsigned int lane = 0; lane < n_lanes; ++lane)
              {
                const unsigned int q = first + lane < rule.size() ? first + lane : 0;
                for (unsigned int d = 0; d < dim - 1; ++d)
                  lane_points[d][lane] = rule.point(q)[d];
                lane_weights[lane] = first + lane < rule.size() ? rule.weight(q) : 0.;
              }
            points.push_back(lane_points);
            weights.push_back(lane_weights);
          }
      }
    };


    double measure(const Outline<2> &interval)
    {
      return interval.empty() ? 0. : interval[1][0] - interval[0][0];
    }
    double measure(const Polygon &polygon)
    {
      return area(polygon);
    }

    Outline<2> overlap(const Outline<2> &a, const Outline<2> &b)
    {
      const double lower = std::max(a[0][0], b[0][0]), upper = std::min(a[1][0], b[1][0]);
      return lower < upper ? Outline<2>{Point<1>(lower), Point<1>(upper)} : Outline<2>();
    }
    Polygon overlap(const Polygon &a, const Polygon &b)
    {
      return clip(a, b);
    }


    /** Points on an interval, exact for the products of linear functions. */
    template <typename Visit>
    void visit_points(const Outline<2> &interval, SegmentRule, const Visit &visit)
    {
      static const LaneRule<2> rule{QGauss<1>(3)};
      const double             length = measure(interval);
      for (std::size_t q = 0; q < rule.points.size(); ++q)
        visit(LanePoint<2>{{interval[0][0] + length * rule.points[q][0]}},
              length * rule.weights[q]);
    }


    /**
     * Points on a polygon, on each triangle of a fan: around its centre, which is more accurate on
     * other quadrilaterals than parallelograms, or from a corner, which needs fewer.
     */
    template <typename Visit>
    void visit_points(const Polygon &polygon, const SegmentRule wanted, const Visit &visit)
    {
      static const LaneRule<3> degree_5{QWitherdenVincentSimplex<2>(3)},
        degree_9{QWitherdenVincentSimplex<2>(5)};
      const bool  from_corner = wanted == SegmentRule::degree_5;
      const auto &rule        = from_corner ? degree_5 : degree_9;
      Point<2>    apex        = polygon[0];
      if (!from_corner)
        {
          apex = Point<2>();
          for (const Point<2> &p : polygon)
            apex += p / static_cast<double>(polygon.size());
        }
      Tensor<1, 2> a = polygon.back() - apex, b;
      for (std::size_t i = 0; i < polygon.size(); ++i, a = b)
        {
          b                     = polygon[i] - apex;
          const double jacobian = a[0] * b[1] - a[1] * b[0];
          for (std::size_t q = 0; q < rule.points.size() && jacobian > 0.; ++q)
            {
              const auto &[r, s] = rule.points[q];
              visit(LanePoint<3>{{apex[0] + r * a[0] + s * b[0], apex[1] + r * a[1] + s * b[1]}},
                    jacobian * rule.weights[q]);
            }
        }
    }


    template <int dim>
    AtPoints<dim> product(const std::array<AtPoints<dim>, dim> &a,
                          const std::array<AtPoints<dim>, dim> &b)
    {
      AtPoints<dim> result = a[0] * b[0];
      for (unsigned int c = 1; c < dim; ++c)
        result += a[c] * b[c];
      return result;
    }


    /** Points on two faces that lie over the same points of the plane. */
    template <int dim>
    struct OppositePoints
    {
      const LanePoint<dim>           slave, master; ///< reference coordinates
      const LaneShapes<dim>          slave_shapes, master_shapes;
      AtPoints<dim>                  surface;          ///< per area in the plane
      std::array<AtPoints<dim>, dim> normal, opposite; ///< unit vectors out of the bodies

      OppositePoints(const LanePoint<dim>     &point,
                     const FacePlane<dim>     &plane,
                     const ProjectedFace<dim> &slave_below,
                     const ProjectedFace<dim> &master_below)
        : slave(slave_below.map_back(point))
        , master(master_below.map_back(point))
        , slave_shapes(ProjectedFace<dim>::shape_values(slave))
        , master_shapes(ProjectedFace<dim>::shape_values(master))
        , normal(slave_below.area_vector(slave))
        , opposite(master_below.area_vector(master))
      {
        for (auto *vector : {&normal, &opposite})
          {
            const AtPoints<dim> factor = 1. / product<dim>(*vector, *vector).sqrt();
            for (AtPoints<dim> &component : *vector)
              component *= factor;
          }
        surface = normal[0] * plane.normal[0];
        for (unsigned int c = 1; c < dim; ++c)
          surface += normal[c] * plane.normal[c];
        surface = 1. / surface;
      }
    };


    /** Of all lanes that have a weight. */
    template <int dim>
    void keep_points(const OppositePoints<dim>      &at,
                     const AtPoints<dim>            &weights,
                     const SurfaceFace<dim>         &slave,
                     const SurfaceFace<dim>         &master,
                     std::vector<SegmentPoint<dim>> &points)
    {
      for (Eigen::Index lane = 0; lane < weights.size(); ++lane)
        if (weights[lane] > 0.)
          {
            SegmentPoint<dim> point;
            for (unsigned int d = 0; d < dim - 1; ++d)
              {
                point.slave[d]  = at.slave[d][lane];
                point.master[d] = at.master[d][lane];
              }
            point.weight = weights[lane] * at.surface[lane];
            for (unsigned int c = 0; c < dim; ++c)
              {
                point.normal[c]   = at.normal[c][lane];
                point.opposite[c] = at.opposite[c][lane];
              }
            point.apart = master.position(point.master) - slave.position(point.slave);
            points.push_back(point);
          }
    }
  } // namespace


  template <int dim>
  SegmentFinder<dim>::SegmentFinder(const SurfaceFace<dim> &slave,
                                    const SegmentRule       rule,
                                    const FacingWeight     &facing)
    : slave(slave)
    , rule(rule)
    , facing(facing)
    , plane(slave)
    , below(slave, plane)
    , outline(below.outline())
    , whole_area(measure(outline))
  {
    below.prepare(slave);
  }


  template <int dim>
  void SegmentFinder<dim>::find(const SurfaceFace<dim> &master, Segment<dim> &segment) const
  {
    ProjectedFace<dim> master_below(master, plane);
    if (!below.may_overlap(master_below))
      return;
    master_below.prepare(master);
    // Beyond 84 degrees faces do not look at each other; a projection would be distorted without
    // bound.
    const Tensor<1, dim> opposite = master_below.area_vector_at_centre();
    if (opposite * plane.normal > -0.1 * opposite.norm())
      return;
    const Outline<dim> common  = overlap(outline, master_below.outline());
    const double       covered = measure(common);
    if (!(covered > 1e-12 * whole_area))
      return;
    segment.area         = covered;
    segment.smallest_gap = smallest_gap(common, master_below);
    integrate(common, master, master_below, segment);
  }


  template <int dim>
  double SegmentFinder<dim>::smallest_gap(const Outline<dim>       &common,
                                          const ProjectedFace<dim> &master) const
  {
    constexpr std::size_t n_lanes = AtPoints<dim>::RowsAtCompileTime;
    double                result  = std::numeric_limits<double>::max();
    for (std::size_t first = 0; first < common.size(); first += n_lanes)
      {
        LanePoint<dim> corners;
        for (std::size_t lane = 0; lane < n_lanes; ++lane)
          for (unsigned int d = 0; d < dim - 1; ++d)
            corners[d][lane] = common[std::min(first + lane, common.size() - 1)][d];
        const auto shapes   = ProjectedFace<dim>::shape_values(below.map_back(corners)),
                   opposite = ProjectedFace<dim>::shape_values(master.map_back(corners));
        result = std::min(result, (master.height(opposite) - below.height(shapes)).minCoeff());
      }
    return result;
  }


  template <int dim>
  void SegmentFinder<dim>::integrate(const Outline<dim>       &common,
                                     const SurfaceFace<dim>   &master,
                                     const ProjectedFace<dim> &master_below,
                                     Segment<dim>             &segment) const
  {
    constexpr int n_vertices = Segment<dim>::n_vertices, n_factors = 2 * (n_vertices + dim),
                  n_lanes = AtPoints<dim>::RowsAtCompileTime;
    // Sums over lanes are left to the end.
    Eigen::Array<double, n_lanes, n_vertices * n_factors> sums;
    sums.setZero();
    AtPoints<dim> gap = AtPoints<dim>::Zero();
    visit_points(common, rule, [&](const LanePoint<dim> &point, const AtPoints<dim> &weights) {
      const OppositePoints<dim> at(point, plane, below, master_below);
      gap += weights * (master_below.height(at.master_shapes) - below.height(at.slave_shapes));
      const AtPoints<dim> counted =
        weights * at.surface * facing(AtPoints<dim>(-product<dim>(at.normal, at.opposite)));
      for (int i = 0; i < n_vertices; ++i)
        {
          const AtPoints<dim> weighted = counted * at.slave_shapes[i];
          auto                factor   = sums.template middleCols<n_factors>(i * n_factors);
          for (int j = 0; j < n_vertices; ++j)
            {
              factor.col(j) += weighted * at.slave_shapes[j];
              factor.col(n_vertices + j) += weighted * at.master_shapes[j];
            }
          for (int c = 0; c < dim; ++c)
            {
              factor.col(2 * n_vertices + c) += weighted * at.normal[c];
              factor.col(2 * n_vertices + dim + c) += weighted * at.opposite[c];
            }
        }
      if (rule == SegmentRule::degree_9)
        keep_points(at, weights, slave, master, segment.points);
    });
    segment.gap                                              = gap.sum() / segment.area;
    const Eigen::Array<double, 1, n_vertices *n_factors> all = sums.colwise().sum();
    const Eigen::Map<const Eigen::Matrix<double, n_vertices, n_factors, Eigen::RowMajor>> rows(
      all.data());
    segment.slave_slave  = rows.template middleCols<n_vertices>(0);
    segment.slave_master = rows.template middleCols<n_vertices>(n_vertices);
    segment.normals      = rows.template middleCols<dim>(2 * n_vertices);
    segment.opposite     = rows.template middleCols<dim>(2 * n_vertices + dim);
  }


  template <int dim>
  Segment<dim>
  intersect(const SurfaceFace<dim> &slave, const SurfaceFace<dim> &master, const SegmentRule rule)
  {
    Segment<dim> segment;
    SegmentFinder<dim>(slave, rule).find(master, segment);
    return segment;
  }


  template class SegmentFinder<2>;
  template class SegmentFinder<3>;
  template Segment<2> intersect(const SurfaceFace<2> &, const SurfaceFace<2> &, SegmentRule);
  template Segment<3> intersect(const SurfaceFace<3> &, const SurfaceFace<3> &, SegmentRule);
} // namespace signorini
