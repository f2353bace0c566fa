// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The normals of contact of two bodies are those of the common tangent plane where they touch: of a
// ball on a plane exactly, whichever of them is the slave; of two balls, equal or not, up to the
// third power of the distance from the point of contact, and the mesh. Curvatures are those of the
// exact surfaces up to the size of the facets. Forces between the bodies stay equal and opposite.

#include "two_bodies.h"

#include <signorini/surfaces/mean_curvature.h>

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /**
   * A ball that touches the plane z = 0 in the origin, from above (side = 1) or from below (-1),
   * with small cells there.
   */
  BodyDescription<3> touching_ball(const std::string &name,
                                   const double       side,
                                   const double       radius,
                                   const unsigned int refinements)
  {
    BodyDescription<3> body;
    body.name              = name;
    ball_of(body).centre   = Point<3>(0., 0., side * radius);
    ball_of(body).radius   = radius;
    body.refinements       = refinements;
    body.local_refinements = 1;
    body.refine_where      = "0.5 - sqrt(x^2 + y^2 + z^2)";
    body.material          = {500., 0.3, 1.};
    return body;
  }

  /** Two bodies with all of their boundaries. */
  Scene<3> facing(const BodyDescription<3> &slave, const BodyDescription<3> &master)
  {
    Scene<3> scene                    = stacked<3>(slave, master);
    scene.pairs[0].slave_boundary_ids = scene.pairs[0].master_boundary_ids = {};
    return scene;
  }

  double distance_from_axis(const ContactNode<3> &node)
  {
    return std::hypot(node.position[0], node.position[1]);
  }

  /**
   * The largest tilt of normals against the axis less the cube of the distance from it, for nodes
   * up to 0.4.
   */
  double tilt_beyond_cube(const TwoBodies<3> &bodies)
  {
    double worst = -1.;
    for (const ContactNode<3> &node : bodies.surface.nodes())
      if (distance_from_axis(node) < 0.4)
        worst = std::max(worst,
                         std::hypot(node.normal()[0], node.normal()[1])
                           - std::pow(distance_from_axis(node), 3));
    return dealii::Utilities::MPI::max(worst, MPI_COMM_WORLD);
  }

  /** Normal forces between the bodies have no resultant, for any values at the nodes. */
  void expect_opposite_forces(const TwoBodies<3> &bodies)
  {
    Vector force = bodies.discretization.make_vector();
    for (const ContactNode<3> &node : bodies.surface.nodes())
      force.local_element(3 * node.node) =
        -1. - std::sin(20. * node.position[0] + 7. * node.position[1]);
    bodies.coordinates.force_to_cartesian(force);
    const Tensor<1, 3> slave  = bodies.resultant_on(0, force),
                       master = bodies.resultant_on(1, force);
    EXPECT_GT(slave.norm(), 1.);
    EXPECT_LT((slave + master).norm(), 1e-12 * slave.norm());
  }
} // namespace

// The projection along the normals of the slave meets the mirror image of a face up to the third
// power of the distance, and so, for a small part of some faces, its neighbour. Normals of the
// slave alone are tilted by up to 0.4.
TEST(Normals, OfTwoEqualBallsAreTheAxis)
{
  const TwoBodies<3> same(
    facing(touching_ball("upper", 1., 1., 3), touching_ball("lower", -1., 1., 3)));
  EXPECT_LT(tilt_beyond_cube(same), 0.01);
  expect_opposite_forces(same);
}

// Facets of the coarser ball have one normal each: the mean of both normals is off by up to half of
// the angle that such a facet spans on either side of its centre, h/(4R) with h = 0.1 (or twice
// that).
TEST(Normals, OfBallsWithDifferentMeshesAreTheAxisUpToAFacet)
{
  for (const bool fine_slave : {true, false})
    {
      const TwoBodies<3> different(facing(touching_ball("upper", 1., 1., fine_slave ? 3 : 2),
                                          touching_ball("lower", -1., 1., fine_slave ? 2 : 3)));
      EXPECT_LT(tilt_beyond_cube(different), 0.05);
      expect_opposite_forces(different);
    }
}

TEST(Normals, OfUnequalBallsAreTheAxis)
{
  const TwoBodies<3> unequal(
    facing(touching_ball("upper", 1., 1., 3), touching_ball("lower", -1., 2., 4)));
  EXPECT_LT(tilt_beyond_cube(unequal), 0.02);
  expect_opposite_forces(unequal);
}

TEST(Normals, OfABallAndAPlaneAreThePlanes)
{
  auto base = block<3>("base", {-1., -1., -1.}, {1., 1., 0.}, {{4, 4, 2}});
  for (const bool slave : {true, false})
    {
      const auto       sphere = touching_ball("ball", 1., 1., 2);
      Scene<3>         scene  = slave ? facing(sphere, base) : facing(base, sphere);
      PairDescription &pair   = scene.pairs[0];
      (slave ? pair.master_boundary_ids : pair.slave_boundary_ids) = {top_id<3>};
      const TwoBodies<3> bodies(scene);
      EXPECT_GT(bodies.surface.n_global_nodes(), 0u);
      for (const ContactNode<3> &node : bodies.surface.nodes())
        EXPECT_NEAR(std::abs(node.normal()[2]), 1., 1e-14) << node.position;
    }
}

TEST(Normals, CurvatureOfASphereFromItsFacets)
{
  // Far from the origin only the round-off of the coordinates themselves is left.
  for (const auto &[radius, centre, tolerance] : std::vector<std::tuple<double, Point<3>, double>>{
         {0.5, {3., -1., 2.}, 1e-12}, {2., {3., -1., 2.}, 1e-12}, {0.5, {3e6, -1e6, 2e6}, 1e-8}})
    {
      MeanCurvature<3> samples;
      const int        n = 20; // parallels and meridians of a cap of 1 radian
      for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
          {
            const double       polar = (i + 0.5) / n, around = 2. * dealii::numbers::PI * k / n;
            const Tensor<1, 3> normal({std::sin(polar) * std::cos(around),
                                       std::sin(polar) * std::sin(around),
                                       std::cos(polar)});
            samples.add(std::sin(polar), centre + radius * normal, normal);
          }
      EXPECT_NEAR(samples.value(MPI_COMM_SELF) * radius, 1., tolerance);
    }
}

TEST(Normals, WithoutCurvatureBothBodiesCountAlike)
{
  const Tensor<1, 3> normal({0.36, 0.48, 0.8});
  MeanCurvature<3>   plane;
  EXPECT_EQ(plane.value(MPI_COMM_SELF), 0.);
  for (const Point<3> &point :
       {Point<3>(0., 0., 0.), Point<3>(1., 0., -0.45), Point<3>(0., 1., -0.6)})
    plane.add(0.3, point, normal);
  EXPECT_EQ(plane.value(MPI_COMM_SELF), 0.);
  EXPECT_EQ(weights_of_normals(0., 0.).slave, 0.5);
  EXPECT_EQ(weights_of_normals(0., 0.).master, 0.5);
  EXPECT_EQ(weights_of_normals(2., 0.).master, 1.);
  EXPECT_DOUBLE_EQ(weights_of_normals(2., 1.).slave, 1. / 3.);
}
