// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A surface of facets has the distance of its nearest point, with the sign of the side on which one
// is, also beside edges and corners of any angle; it is a box, a plane with an end, or nearly a
// sphere, if that is what its facets make. Only what comes from the data of facets may differ: the
// round-off of coordinates, and for a sphere the square of the size of its facets.

#include "facets.h"

#include <signorini/obstacles/box_obstacle.h>
#include <signorini/obstacles/box_tree.h>
#include <signorini/obstacles/moved_obstacle.h>
#include <signorini/obstacles/plane.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Points in a cube about the origin, the same ones at any time. */
  template <int dim>
  std::vector<Point<dim>> scattered(const unsigned int n, const double half)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> coordinate(-half, half);
    std::vector<Point<dim>>                points(n);
    for (Point<dim> &point : points)
      for (unsigned int c = 0; c < dim; ++c)
        point[c] = coordinate(random);
    return points;
  }

  template <int dim>
  void expect_same(const RigidObstacle<dim> &obstacle,
                   const RigidObstacle<dim> &expected,
                   const Point<dim>         &point)
  {
    const auto own = obstacle.project(point), other = expected.project(point);
    EXPECT_NEAR(own.gap, other.gap, 1e-14) << point;
    EXPECT_LT((own.normal - other.normal).norm(), 1e-13) << point;
    EXPECT_EQ(own.is_carried(1e-10), other.is_carried(1e-10)) << point;
  }
} // namespace

TEST(MeshObstacle, ABoxOfTrianglesIsABox)
{
  const auto           mesh = obstacle_of(cuboid(1., 2., 0.5));
  const BoxObstacle<3> box({0., 0., 0.}, {1., 2., 0.5});
  for (const Point<3> &point : scattered<3>(2000, 3.))
    expect_same<3>(mesh, box, point);
  EXPECT_FALSE(mesh.has_end());
  EXPECT_TRUE(mesh.sides().empty()); // no inner corners

  // On a face and above it the two triangles are one plane, to the last digit.
  for (const double x : {0.2, 0.25, 0.4, 0.5})
    EXPECT_EQ(mesh.project({x, 0.5, 0.75}).gap, 0.25) << x;
}

TEST(MeshObstacle, ARectangleOfSegmentsIsABox)
{
  const auto           mesh = obstacle_of(polygon({{0., 0.}, {4., 0.}, {4., 2.}, {0., 2.}}));
  const BoxObstacle<2> box({0., 0.}, {4., 2.});
  for (const Point<2> &point : scattered<2>(2000, 5.))
    expect_same<2>(mesh, box, point);
}

// Whichever way its facets go round, and whether its vertices are shared or not.
TEST(MeshObstacle, OrientationDoesNotMatter)
{
  FacetMesh<3> turned = cuboid(1., 2., 0.5), separate;
  for (unsigned int f = 0; f < turned.facets.size(); ++f)
    {
      if (f % 3 != 1)
        std::swap(turned.facets[f][0], turned.facets[f][2]);
      separate.facets.push_back({{3 * f, 3 * f + 1, 3 * f + 2}});
      for (const unsigned int v : turned.facets[f])
        separate.vertices.push_back(turned.vertices[v]);
    }
  const auto expected = obstacle_of(cuboid(1., 2., 0.5));
  for (const FacetMesh<3> &mesh : {turned, separate})
    for (const Point<3> &point : scattered<3>(100, 3.))
      expect_same<3>(obstacle_of(mesh), expected, point);
  const auto hollow = std::make_shared<FacetedSurface<3>>(separate, false);
  hollow->turn_inside_out();
  EXPECT_NEAR(MeshObstacle<3>(hollow).project({0.5, 1., 0.1}).gap, 0.1, 1e-15);
}

TEST(MeshObstacle, AGlobeIsNearlyASphere)
{
  double former = 0.;
  for (const unsigned int n : {10, 20, 40})
    {
      const auto mesh  = obstacle_of(globe(n));
      double     wrong = 0.;
      for (const Point<3> &point : scattered<3>(300, 2.))
        {
          const auto way = mesh.project(point);
          wrong          = std::max(wrong, std::abs(way.gap - (point.norm() - 1.)));
          // A facet, or what is between those that meet, is as far from the sphere's normal.
          if (point.norm() > 0.5)
            {
              EXPECT_LT((way.normal + point / point.norm()).norm(), 4. / n) << point;
            }
        }
      if (former > 0.)
        {
          EXPECT_NEAR(former / wrong, 4., 0.6) << n;
        }
      former = wrong;
    }
}

// A thin spike has corners at which the nearest facet alone says the wrong side.
TEST(MeshObstacle, TheSignIsRightAtSharpCorners)
{
  const FacetMesh<3> spike{{{0., 0., 0.}, {0.1, 0., 0.}, {0., 0.1, 0.}, {1., 1., 1.}},
                           {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}};
  const auto         mesh    = obstacle_of(spike);
  const auto         is_side = [&](const Point<3> &p, const unsigned int facet) {
    const auto        &v      = spike.facets[facet];
    const Tensor<1, 3> normal = cross_product_3d(spike.vertices[v[1]] - spike.vertices[v[0]],
                                                 spike.vertices[v[2]] - spike.vertices[v[0]]);
    return (p - spike.vertices[v[0]]) * normal < 0.;
  };
  unsigned int n_inside = 0;
  for (const Point<3> &offset : scattered<3>(4000, 0.1))
    for (const Point<3> &corner : spike.vertices)
      {
        const Point<3> p(corner + 0.3 * offset);
        bool           inside = true;
        for (unsigned int f = 0; f < 4; ++f)
          inside = inside && is_side(p, f);
        n_inside += inside;
        EXPECT_EQ(mesh.project(p).gap < 0., inside) << p;
      }
  EXPECT_GT(n_inside, 20u);
}

TEST(MeshObstacle, AnOpenLineEndsLikeAPlaneWithAnExtent)
{
  // The obstacle is to the left of the line.
  const auto     mesh = obstacle_of(line({{1., 0.5}, {0.25, 0.5}, {-1., 0.5}}), true);
  const Plane<2> plane({0., 0.5}, Tensor<1, 2>({0., 1.}), {{Tensor<1, 2>({1., 0.}), 1.}});
  EXPECT_TRUE(mesh.has_end());
  for (const Point<2> &point : scattered<2>(500, 2.))
    {
      const auto own = mesh.project(point), other = plane.project(point);
      EXPECT_NEAR(own.gap, other.gap, 1e-14) << point;
      EXPECT_LT((own.normal - other.normal).norm(), 1e-14) << point;
      EXPECT_NEAR(own.beyond, other.beyond, 1e-14) << point;
    }
}

// The condition of a motion says what the gap at its end is: along facets, and across edges where
// the normals of neighbours differ little. Across an edge of a box the plane of the start holds.
TEST(MeshObstacle, ConditionOfAMotionIsItsGapAtTheEnd)
{
  const auto     mesh = obstacle_of(globe(60));
  const Point<3> start(0.3, 0.2, 1.);
  for (const double size : {0., 1e-12, 1e-6, 1e-3, 0.1})
    for (const Tensor<1, 3> &direction :
         {Tensor<1, 3>({1., 0., 0.}), Tensor<1, 3>({0., 0., -1.}), Tensor<1, 3>({-2., 1., 1.})})
      {
        const Tensor<1, 3> motion    = size * direction;
        const auto         condition = mesh.condition_of_motion(start, start + motion);
        EXPECT_TRUE(condition.is_exact) << motion;
        EXPECT_NEAR(condition.gap_after(motion), mesh.project(start + motion).gap, 2e-14);
      }
  const auto box = obstacle_of(cuboid(1., 1., 1.));
  EXPECT_FALSE(box.condition_of_motion({0.5, 0.5, 1.}, {1.4, 0.5, 0.8}).is_exact);
}

// In the corner of an L both walls hold a point, and each goes on past the other.
TEST(MeshObstacle, SidesMeetInInnerCorners)
{
  const auto mesh =
    obstacle_of(polygon({{0., 0.}, {3., 0.}, {3., 1.}, {1., 1.}, {1., 3.}, {0., 3.}}));
  const auto sides = mesh.sides();
  ASSERT_EQ(sides.size(), 6u);
  const Point<2> near(1.1, 1.15);
  const auto     found = mesh.sides_near(near, near, 0.2);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(sides[found[0]]->project(near).gap, 0.1, 1e-15);
  EXPECT_NEAR(sides[found[1]]->project(near).gap, 0.15, 1e-15);
  const auto inside = sides[found[1]]->project({0.9, 0.95});
  EXPECT_NEAR(inside.gap, -0.05, 1e-15);
  EXPECT_TRUE(inside.is_carried(1e-10));
  EXPECT_TRUE(mesh.sides_near(near, near, 0.12).empty());                // out of reach
  EXPECT_TRUE(mesh.sides_near({3.05, 0.9}, {3.05, 0.9}, 0.2).empty());   // an outer corner
  EXPECT_TRUE(mesh.sides_near({1.1, 1.15}, {0.5, 3.5}, 4.).empty());     // leads past them
  EXPECT_FALSE(sides[found[1]]->project({3.1, 0.99}).is_carried(1e-10)); // past its outer end
}

// Three walls of a room meet in its corner.
TEST(MeshObstacle, ThreeSidesInTheCornerOfARoom)
{
  const auto surface = std::make_shared<FacetedSurface<3>>(cuboid(1., 1., 1.), false);
  surface->turn_inside_out();
  const MeshObstacle<3> room(surface);
  const Point<3>        near(0.01, 0.02, 0.97);
  const auto            found = room.sides_near(near, near, 0.1);
  ASSERT_EQ(found.size(), 3u);
  for (unsigned int k = 0; k < 3; ++k)
    EXPECT_NEAR(room.sides()[found[k]]->project(near).gap, 0.01 * (k + 1), 1e-15);
  MovedObstacle<3> moved({"room", std::make_shared<MeshObstacle<3>>(surface)});
  EXPECT_EQ(moved.most_conditions(), 3u);
  EXPECT_EQ(moved.facets().size(), 12u);
}

TEST(MeshObstacle, TheTreeFindsTheNearest)
{
  const auto                          places = scattered<3>(500, 1.);
  std::vector<dealii::BoundingBox<3>> boxes;
  for (const Point<3> &place : places)
    boxes.emplace_back(std::make_pair(place, place));
  const BoxTree<3> tree(boxes);
  for (const Point<3> &p : scattered<3>(200, 2.))
    {
      double       least    = 1e9;
      unsigned int n_looked = 0, n_near = 0, n_found = 0;
      for (const Point<3> &place : places)
        {
          least = std::min(least, p.distance_square(place));
          n_near += p.distance(place) <= 1.;
        }
      const double found = tree.least_square_distance(p, [&](const unsigned int k) {
        ++n_looked;
        return p.distance_square(places[k]);
      });
      EXPECT_EQ(found, least);
      EXPECT_LT(n_looked, 100u);
      tree.for_each_near(
        p, 1., [&](const unsigned int k) { n_found += p.distance(places[k]) <= 1.; });
      EXPECT_EQ(n_found, n_near);
    }
}

// Squares of their distances are no numbers: whatever is found, nothing breaks.
TEST(MeshObstacle, PointsOutOfReachDoNoHarm)
{
  const auto mesh = obstacle_of(cuboid(1., 2., 0.5));
  for (const double far : {1e160, 1e308, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_NO_THROW(mesh.try_project({far, -far, 0.}));
  EXPECT_FALSE(mesh.project({1e160, 0., 0.}).gap < 0.);
}
