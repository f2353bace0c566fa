// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The geometry of the mortar coupling: clipped polygons have the areas that one computes by hand, a
// segment integrates over exactly the common part of two faces with points on lines along the slave
// normal, and the segments of whole surfaces add up to their overlap.

#include "two_bodies.h"

#include <signorini/surfaces/face_segments.h>
#include <signorini/surfaces/polygon_clipping.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

// Of its own: all tests of a folder are compiled as one.
namespace mortar_geometry_tests
{
  namespace
  {
    Polygon rectangle(const double x0, const double y0, const double x1, const double y1)
    {
      return {Point<2>(x0, y0), Point<2>(x1, y0), Point<2>(x1, y1), Point<2>(x0, y1)};
    }

    Polygon
    turned(const Polygon &polygon, const double angle, const Tensor<1, 2> &shift = Tensor<1, 2>())
    {
      Polygon result;
      for (const Point<2> &p : polygon)
        result.push_back(Point<2>(rotation<2>(angle) * Tensor<1, 2>(p) + shift));
      return result;
    }

    /** Both ways round, which has to give the same area. */
    void expect_common_area(const Polygon &a, const Polygon &b, const double expected)
    {
      EXPECT_NEAR(area(clip(a, b)), expected, 1e-15);
      EXPECT_NEAR(area(clip(b, a)), expected, 1e-15);
    }

    /** A face with its outward side on the side of `outward`. */
    template <int dim>
    SurfaceFace<dim> face(const std::vector<Point<dim>> &vertices, const Tensor<1, dim> &outward)
    {
      SurfaceFace<dim> result;
      std::copy(vertices.begin(), vertices.end(), result.vertices.begin());
      Point<dim - 1> middle;
      for (unsigned int d = 0; d < dim - 1; ++d)
        middle[d] = 0.5;
      if (result.area_vector(middle) * outward < 0.)
        result.orientation = -1.;
      return result;
    }

    template <int dim>
    SurfaceFace<dim> turned(const SurfaceFace<dim> &original, const double angle)
    {
      SurfaceFace<dim> result = original;
      for (Point<dim> &vertex : result.vertices)
        vertex = Point<dim>(rotation<dim>(angle) * Tensor<1, dim>(vertex)
                            + Tensor<1, dim>(Point<dim>::unit_vector(0)));
      return result;
    }

    const Tensor<1, 3> up({0., 0., 1.}), down({0., 0., -1.});

    /** A quadrilateral in the plane z = a + b x + c y over corners in lexicographic order. */
    SurfaceFace<3> quadrilateral(const std::vector<Point<2>> &corners,
                                 const Point<3>              &plane,
                                 const Tensor<1, 3>          &outward)
    {
      std::vector<Point<3>> vertices;
      for (const Point<2> &p : corners)
        vertices.emplace_back(p[0], p[1], plane[0] + plane[1] * p[0] + plane[2] * p[1]);
      return face<3>(vertices, outward);
    }

    const std::vector<Point<2>> unit_square = {{0., 0.}, {1., 0.}, {0., 1.}, {1., 1.}},
                                distorted   = {{-0.1, 0.2}, {1.3, -0.2}, {0.1, 0.9}, {0.9, 1.4}},
                                small       = {{0.2, 0.3}, {0.7, 0.4}, {0.1, 0.6}, {0.8, 0.9}};

    Polygon outline(const std::vector<Point<2>> &corners)
    {
      return {corners[0], corners[1], corners[3], corners[2]};
    }

    template <int dim>
    Tensor<1, dim> central_normal(const SurfaceFace<dim> &face)
    {
      Point<dim - 1> middle;
      for (unsigned int d = 0; d < dim - 1; ++d)
        middle[d] = 0.5;
      const Tensor<1, dim> normal = face.area_vector(middle);
      return normal / normal.norm();
    }

    template <int dim>
    void expect_points_on_lines(const Segment<dim>     &segment,
                                const SurfaceFace<dim> &slave,
                                const SurfaceFace<dim> &master)
    {
      const Tensor<1, dim> normal = central_normal(slave);
      for (const SegmentPoint<dim> &point : segment.points)
        {
          EXPECT_GT(point.weight, 0.);
          for (unsigned int d = 0; d < dim - 1; ++d)
            for (const double xi : {point.slave[d], point.master[d]})
              EXPECT_TRUE(xi > 0. && xi < 1.) << xi << ": inside of both faces";
          const Tensor<1, dim> across = master.position(point.master) - slave.position(point.slave);
          EXPECT_LT((across - (across * normal) * normal).norm(), 1e-13);
        }
    }

    /** Integral of a function of the position on the slave face over a segment. */
    template <int dim, typename Function>
    double
    integral(const Segment<dim> &segment, const SurfaceFace<dim> &slave, const Function &function)
    {
      double sum = 0.;
      for (const SegmentPoint<dim> &point : segment.points)
        sum += point.weight * function(slave.position(point.slave));
      return sum;
    }
  } // namespace

  TEST(Clipping, AreasByHand)
  {
    const Polygon unit = rectangle(0., 0., 1., 1.);
    expect_common_area(unit, rectangle(0.5, 0.25, 1.5, 2.), 0.5 * 0.75);
    expect_common_area(unit, rectangle(0.25, 0.5, 0.75, 0.75), 0.5 * 0.25); // containing
    expect_common_area(unit, unit, 1.);
    expect_common_area(unit, rectangle(0., 0., 0.5, 1.), 0.5);     // three common edges
    expect_common_area(unit, rectangle(-1., 0.25, 2., 0.5), 0.25); // a cross
    expect_common_area(unit, rectangle(0.5, 0., 1.5, 1.), 0.5);    // edges on one line
    const Polygon diamond = {{1.5, 0.}, {0., 1.5}, {-1.5, 0.}, {0., -1.5}};
    expect_common_area(rectangle(-1., -1., 1., 1.), diamond, 3.5);
    EXPECT_EQ(clip(diamond, rectangle(-1., -1., 1., 1.)).size(), 8u);
    const Polygon inscribed = {
      {1., 0.}, {0., 1.}, {-1., 0.}, {0., -1.}}; // its corners on edges of the other
    expect_common_area(rectangle(-1., -1., 1., 1.), inscribed, 2.);
    const Polygon triangle = {{0., 0.}, {2., 0.}, {0., 2.}},
                  opposite = {{1.5, 1.5}, {-0.5, 1.5}, {1.5, -0.5}};
    expect_common_area(triangle, opposite, 2. - 2. * 0.125 - 0.5);
  }

  TEST(Clipping, NothingInCommon)
  {
    const Polygon unit = rectangle(0., 0., 1., 1.);
    for (const Polygon &other : {rectangle(2., 0., 3., 1.),     // apart
                                 rectangle(1., 0., 2., 1.),     // a common edge
                                 rectangle(1., 1., 2., 2.),     // a common corner
                                 rectangle(0.25, 1., 0.75, 2.), // part of an edge
                                 Polygon{{2.01, 0.}, {0., 2.01}, {2., 2.}}})
      expect_common_area(unit, other, 0.);
  }

  TEST(Clipping, OrientationIsTheSignOfTheArea)
  {
    Polygon l = {{0., 0.}, {3., 0.}, {2., 1.}, {0., 1.}};
    EXPECT_DOUBLE_EQ(area(l), 2.5);
    std::reverse(l.begin(), l.end());
    EXPECT_DOUBLE_EQ(area(l), -2.5);
  }

  // Of squares turned against each other: commutative, additive over a partition of the window,
  // nothing lost.
  TEST(Clipping, PartsAddUp)
  {
    const Polygon subject = rectangle(-1., -1., 1., 1.);
    for (const double angle : {0., 0.3, 0.785398163397448279, 1.5707963267948966, 2.})
      for (const double shift : {0., 0.4, 1., 1.7})
        {
          const Tensor<1, 2> along({shift, 0.3 * shift});
          const Polygon      window = turned(rectangle(-1.2, -0.7, 0.8, 1.1), angle, along);
          const double       whole  = area(clip(subject, window));
          EXPECT_NEAR(whole, area(clip(window, subject)), 1e-14) << angle << " " << shift;
          EXPECT_GT(whole, 0.);
          double parts = 0.;
          for (unsigned int i = 0; i < 7; ++i)
            for (unsigned int j = 0; j < 5; ++j)
              parts += area(clip(subject,
                                 turned(rectangle(-1.2 + 2. / 7. * i,
                                                  -0.7 + 0.36 * j,
                                                  -1.2 + 2. / 7. * (i + 1),
                                                  -0.7 + 0.36 * (j + 1)),
                                        angle,
                                        along)));
          EXPECT_NEAR(whole, parts, 1e-14) << angle << " " << shift;
        }
  }

  TEST(Segments, ParallelFacesIn3d)
  {
    for (const double angle : {0., 0.7})
      for (const auto &corners : {unit_square, distorted, small})
        for (const auto &other : {unit_square, distorted, small})
          {
            const auto    slave   = turned(quadrilateral(corners, {0., 0., 0.}, down), angle);
            const auto    master  = turned(quadrilateral(other, {-0.3, 0., 0.}, up), angle);
            const Polygon common  = clip(outline(corners), outline(other));
            const auto    segment = intersect(slave, master);
            EXPECT_NEAR(segment.area, area(common), 1e-14);
            EXPECT_NEAR(
              integral(segment, slave, [](const Point<3> &) { return 1.; }), area(common), 1e-13);
            EXPECT_NEAR(segment.gap, 0.3, 1e-14);
            EXPECT_NEAR(projected_area(slave), area(outline(corners)), 1e-14);
            expect_points_on_lines(segment, slave, master);
          }
  }

  // The integrands of the mass matrices are quadratic on flat faces; the part of the unit square
  // left of x + y = 1 is known.
  TEST(Segments, IntegrateQuadraticFunctions)
  {
    const auto slave = quadrilateral(unit_square, {0., 0., 0.}, down);
    const auto master =
      quadrilateral({{-1., -1.}, {1., 0.}, {-1., 2.}, {0., 1.}}, {-1., 0., 0.}, up);
    const auto common = intersect(slave, master);
    EXPECT_NEAR(integral(common, slave, [](const Point<3> &p) { return p[0]; }), 1. / 6., 1e-14);
    EXPECT_NEAR(
      integral(common, slave, [](const Point<3> &p) { return p[0] * p[0]; }), 1. / 12., 1e-14);
    EXPECT_NEAR(
      integral(common, slave, [](const Point<3> &p) { return p[0] * p[1]; }), 1. / 24., 1e-14);
  }

  TEST(Segments, InclinedMaster)
  {
    const auto slave = quadrilateral(unit_square, {0., 0., 0.}, down);
    const auto master =
      quadrilateral({{-1., -1.}, {0.5, -1.}, {-1., 2.}, {0.5, 2.}}, {-0.3, 0.2, -0.1}, up);
    for (const double angle : {0., 0.7})
      {
        const auto a = turned(slave, angle), b = turned(master, angle);
        const auto segment = intersect(a, b);
        EXPECT_NEAR(segment.area, 0.5, 1e-14);
        EXPECT_NEAR(segment.gap, 0.3 - 0.2 * 0.25 + 0.1 * 0.5, 1e-14);
        expect_points_on_lines(segment, a, b);
      }
  }

  // The weights are those of the slave surface; seen from the plane across the central normal, they
  // are shorter by its cosine.
  TEST(Segments, WarpedSlave)
  {
    const auto slave =
      face<3>({{0., 0., 0.1}, {1., 0., -0.1}, {0., 1., -0.1}, {1., 1., 0.1}}, down);
    const auto master =
      quadrilateral({{0.2, -1.}, {2., -1.}, {0.4, 2.}, {2., 2.}}, {-0.3, 0.1, 0.}, up);
    const auto segment = intersect(slave, master);
    expect_points_on_lines(segment, slave, master);
    EXPECT_NEAR(segment.area, 0.7, 1e-14)
      << "the left edge of the master is at x = 0.3 in the mean";
    double projected = 0., surface = 0.;
    for (const auto &point : segment.points)
      {
        const Tensor<1, 3> vector = slave.area_vector(point.slave);
        projected += point.weight * (vector * central_normal(slave)) / vector.norm();
        surface += point.weight;
      }
    EXPECT_NEAR(projected, segment.area, 1e-14);
    EXPECT_GT(surface, segment.area * 1.001);
  }

  TEST(Segments, In2d)
  {
    const auto slave = face<2>({{0., 0.}, {2., 0.}}, Tensor<1, 2>({0., -1.}));
    for (const double angle : {0., 0.7})
      for (const bool reversed : {false, true})
        {
          std::vector<Point<2>> ends = {{0.5, -0.4}, {3., -0.4 + 0.25}};
          if (reversed)
            std::reverse(ends.begin(), ends.end());
          const auto a       = turned(slave, angle),
                     b       = turned(face<2>(ends, Tensor<1, 2>({0., 1.})), angle);
          const auto segment = intersect(a, b);
          EXPECT_NEAR(segment.area, 1.5, 1e-15);
          EXPECT_NEAR(integral(segment, a, [](const Point<2> &) { return 1.; }), 1.5, 1e-14);
          EXPECT_NEAR(segment.gap, 0.4 - 0.1 * 0.75, 1e-14);
          expect_points_on_lines(segment, a, b);
        }
  }

  TEST(Segments, BehindTheSlaveFaceTheGapIsNegative)
  {
    const auto slave = quadrilateral(unit_square, {0., 0., 0.}, down);
    EXPECT_NEAR(intersect(slave, quadrilateral(distorted, {0.1, 0., 0.}, up)).gap, -0.1, 1e-15);
  }

  TEST(Segments, FacesThatDoNotLookAtEachOther)
  {
    const auto slave  = quadrilateral(unit_square, {0., 0., 0.}, down);
    const auto steep  = face<3>({{0.4, 0., -1.}, {0.5, 0., 1.}, {0.4, 1., -1.}, {0.5, 1., 1.}},
                               Tensor<1, 3>({-20., 0., 1.}));
    const auto far    = quadrilateral({{2., 2.}, {3., 2.}, {2., 3.}, {3., 3.}}, {-0.1, 0., 0.}, up);
    const auto beside = quadrilateral({{1., 0.}, {2., 0.}, {1., 1.}, {2., 1.}}, {-0.1, 0., 0.}, up);
    for (const SurfaceFace<3> &master : std::vector<SurfaceFace<3>>{
           quadrilateral(unit_square, {-0.1, 0., 0.}, down), steep, far, beside})
      {
        EXPECT_TRUE(intersect(slave, master).points.empty());
        EXPECT_TRUE(intersect(master, slave).points.empty());
      }
    EXPECT_FALSE(intersect(slave, quadrilateral(unit_square, {-0.1, 0., 0.}, up)).points.empty());

    const auto flat = face<2>({{0., 0.}, {2., 0.}}, Tensor<1, 2>({0., -1.}));
    EXPECT_TRUE(
      intersect(flat, face<2>({{0., -1.}, {2., -1.}}, Tensor<1, 2>({0., -1.}))).points.empty());
    EXPECT_TRUE(
      intersect(flat, face<2>({{2., -1.}, {3., -1.}}, Tensor<1, 2>({0., 1.}))).points.empty());
  }

  // The segments of non-matching surfaces add up to what is opposite: no face is forgotten, none
  // counts twice.
  TEST(CoveredArea, OfBlocks)
  {
    const double root = std::sqrt(2.), pi = dealii::numbers::PI;
    for (const double angle : {0., 0.7})
      {
        // Equal footprint 1 to 3; slave smaller; slave larger; overlap of a corner, also with a gap
        // between the bodies.
        const auto flat = block<3>("flat", {0., 0., -1.}, {1., 1., 0.}, {{3, 3, 1}});
        const auto area = [&](const Point<3> &lower, const Point<3> &upper) {
          const TwoBodies<3> bodies(stacked<3>(block<3>("slave", lower, upper, {{2, 3, 1}}), flat),
                                    turn<3>(angle));
          EXPECT_NEAR(
            bodies.mortar.slave_area(), (upper[0] - lower[0]) * (upper[1] - lower[1]), 1e-13);
          return bodies.mortar.covered_area();
        };
        EXPECT_NEAR(area({0., 0., 0.}, {1., 1., 1.}), 1., 1e-13);
        EXPECT_NEAR(area({0.1, 0.2, 0.}, {root / 2., pi / 4., 1.}),
                    (root / 2. - 0.1) * (pi / 4. - 0.2),
                    1e-13);
        EXPECT_NEAR(area({-root, -pi, 0.}, {root, pi, 1.}), 1., 1e-13);
        EXPECT_NEAR(
          area({root / 3., -0.3, 0.25}, {root, pi / 5., 1.}), (1. - root / 3.) * (pi / 5.), 1e-13);
      }
  }

  TEST(CoveredArea, In2d)
  {
    const double root = std::sqrt(2.);
    for (const double angle : {0., 0.7})
      for (const unsigned int n : {1, 3, 7})
        {
          const auto slave = block<2>("slave", {0., 0.}, {1., 1.}, {{4, 1}});
          EXPECT_NEAR(TwoBodies<2>(
                        stacked<2>(slave, block<2>("master", {root / 3., -1.}, {2., 0.}, {{n, 1}})),
                        turn<2>(angle))
                        .mortar.covered_area(),
                      1. - root / 3.,
                      1e-14);
          EXPECT_NEAR(
            TwoBodies<2>(stacked<2>(slave, block<2>("master", {-root, -1.}, {2., -0.5}, {{n, 1}})),
                         turn<2>(angle))
              .mortar.covered_area(),
            1.,
            1e-14);
        }
  }

  // The end of a cylinder is a polygon with inclined edges; a block that is larger sees all of it,
  // a smaller one is covered, and a quarter plane sees a quarter.
  TEST(CoveredArea, OfBlocksOnACylinder)
  {
    BodyDescription<3> column;
    column.name                            = "column";
    shape_of<CylinderShape>(column).length = 2.;
    shape_of<CylinderShape>(column).centre = Point<3>(0., 0., -1.);
    column.refinements                     = 1;
    column.material                        = {500., 0.3, 2.};
    const auto covered                     = [&](const Point<3> &lower, const Point<3> &upper) {
      Scene<3> scene = stacked<3>(block<3>("slave", lower, upper, {{3, 5, 1}}), column);
      scene.pairs[0].master_boundary_ids = {2};
      return TwoBodies<3>(scene, turn<3>(0.4)).mortar.covered_area();
    };
    EXPECT_NEAR(covered({-1.5, -1.5, 0.}, {1.4, 1.3, 1.}), polygon_area(8), 1e-13);
    EXPECT_NEAR(covered({-0.4, -0.3, 0.}, {0.5, 0.35, 1.}), 0.9 * 0.65, 1e-13);
    EXPECT_NEAR(covered({0., 0., 0.1}, {2., 2., 1.}), polygon_area(8) / 4., 1e-13);
  }
} // namespace mortar_geometry_tests
