// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The gap is the distance to the obstacle, negative inside of it, and the normal is the unit vector
// towards the obstacle, against the gradient of the distance.

#include <signorini/base/user_error.h>
#include <signorini/obstacles/box_obstacle.h>
#include <signorini/obstacles/level_set.h>
#include <signorini/obstacles/moved_obstacle.h>
#include <signorini/obstacles/plane.h>
#include <signorini/obstacles/round_obstacle.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace signorini;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Gap and normal at a point. */
  template <int dim>
  void expect_projection(const RigidObstacle<dim> &obstacle,
                         const Point<dim>         &point,
                         const double              gap,
                         const Tensor<1, dim>     &normal)
  {
    const auto projection = obstacle.project(point);
    EXPECT_NEAR(projection.gap, gap, 1e-14) << point;
    EXPECT_LT((projection.normal - normal).norm(), 1e-14) << projection.normal << " at " << point;
    EXPECT_NEAR(projection.normal.norm(), 1., 1e-14) << point;
  }

  template <int dim>
  RoundObstacle<dim>
  sphere(const Point<dim> &centre, const double radius, const bool bodies_inside = false)
  {
    return {centre, Tensor<1, dim>(), radius, bodies_inside};
  }
} // namespace

TEST(Obstacles, PlaneWithANormalOfAnyLength)
{
  const Plane<2> wall(Point<2>(1., 0.), Tensor<1, 2>({3., 4.}));
  expect_projection<2>(wall, {4., 4.}, 5., Tensor<1, 2>({-0.6, -0.8}));
  expect_projection<2>(wall, {-2., -4.}, -5., Tensor<1, 2>({-0.6, -0.8}));
  expect_projection<2>(wall, {5., -3.}, 0., Tensor<1, 2>({-0.6, -0.8}));
}

TEST(Obstacles, PlaneEndsWithItsExtent)
{
  // A table of half lengths 2 along x and 0.5 along y, turned by 90 degrees: it is the top of a
  // block, and the way out of the block is the shorter one.
  const Plane<3> table({1., 0., 1.},
                       Tensor<1, 3>({0., 0., 2.}),
                       {{Tensor<1, 3>({1., 0., 0.}), 2.}, {Tensor<1, 3>({0., 1., 0.}), 0.5}});
  const auto     expect = [&](const Point<3> &p,
                          const double    gap,
                          const double    beyond,
                          const double    depth,
                          const bool      carried,
                          const double    distance) {
    const auto projection = table.project(p);
    EXPECT_NEAR(projection.gap, gap, 1e-14) << p;
    EXPECT_NEAR(projection.beyond, beyond, 1e-14) << p;
    EXPECT_NEAR(projection.depth(), depth, 1e-14) << p;
    EXPECT_EQ(projection.is_carried(1e-10), carried) << p;
    EXPECT_NEAR(projection.distance(), distance, 1e-14) << p;
  };
  EXPECT_TRUE(table.has_end());
  expect({1., 0., 1.5}, 0.5, -0.5, 0., true, 0.5);
  expect({3., 0.5, 1.5}, 0.5, 0., 0., true, 0.5);        // above the corner
  expect({3.4, 0., 1.3}, 0.3, 0.4, 0., false, 0.5);      // past the end
  expect({3.4, 0., 0.}, -1., 0.4, 0., false, 0.4);       // beside the block
  expect({1., 0., 0.8}, -0.2, -0.5, 0.2, true, 0.);      // pressed in from above
  expect({1., 0.45, 0.8}, -0.2, -0.05, 0.05, false, 0.); // come in through the side
  EXPECT_FALSE(Plane<2>({0., 0.}, Tensor<1, 2>({0., 1.})).has_end());
}

TEST(Obstacles, SphereFromOutsideAndFromInside)
{
  const Point<3> centre(1., 2., 3.);
  expect_projection<3>(sphere<3>(centre, 2.), {1., 2., 6.}, 1., Tensor<1, 3>({0., 0., -1.}));
  expect_projection<3>(sphere<3>(centre, 2.), {1., 2., 4.}, -1., Tensor<1, 3>({0., 0., -1.}));
  expect_projection<3>(sphere<3>(centre, 2., true), {1., 2., 4.}, 1., Tensor<1, 3>({0., 0., 1.}));
  expect_projection<3>(sphere<3>(centre, 2., true), {4., 2., 3.}, -1., Tensor<1, 3>({1., 0., 0.}));
  expect_projection<2>(sphere<2>({0., 0.}, 1.), {3., 4.}, 4., Tensor<1, 2>({-0.6, -0.8}));
}

TEST(Obstacles, CentreOfASphereHasSomeNormal)
{
  const auto projection = sphere<3>({1., 2., 3.}, 2., true).project({1., 2., 3.});
  EXPECT_DOUBLE_EQ(projection.gap, 2.);
  EXPECT_DOUBLE_EQ(projection.normal.norm(), 1.);
}

TEST(Obstacles, CylinderIgnoresTheWayAlongItsAxis)
{
  const Point<3>     centre(0., 0., 1.);
  const Tensor<1, 3> axis({0., 5., 0.});
  for (const double y : {-10., 0., 3.})
    expect_projection<3>(
      RoundObstacle<3>(centre, axis, 2., false), {3., y, 5.}, 3., Tensor<1, 3>({-0.6, 0., -0.8}));
  expect_projection<3>(
    RoundObstacle<3>(centre, axis, 2., true), {0.6, 7., 1.8}, 1., Tensor<1, 3>({0.6, 0., 0.8}));
}

TEST(Obstacles, AxisOfACylinderHasANormalAcrossIt)
{
  for (const auto &axis : {Tensor<1, 3>({0., 0., 1.}), Tensor<1, 3>({0.1, 0., 1.})})
    {
      const auto projection =
        RoundObstacle<3>(Point<3>(1., 2., 3.), axis, 2., true).project({1., 2., 3.});
      EXPECT_DOUBLE_EQ(projection.gap, 2.);
      EXPECT_DOUBLE_EQ(projection.normal.norm(), 1.);
      EXPECT_NEAR(projection.normal * axis, 0., 1e-15);
    }
}

TEST(Obstacles, FunctionIsScaledToADistance)
{
  const LevelSet<3> ball("ball", "5*(sqrt(x*x + y*y + z*z) - 1)");
  for (const Point<3> &point :
       {Point<3>(0., 0., 2.), Point<3>(0.6, 0., 0.8), Point<3>(-1., 2., 2.), Point<3>(0., 0.5, 0.)})
    expect_projection<3>(ball, point, point.norm() - 1., -point / point.norm());
  expect_projection<3>(LevelSet<3>("slope", "z - 0.1*x"),
                       {0., 0., 0.},
                       0.,
                       Tensor<1, 3>({0.1, 0., -1.}) / std::sqrt(1.01));
}

TEST(Obstacles, FunctionIsExactOnItsSurface)
{
  // Here the expression is an area, not a length.
  const LevelSet<2> ellipse("ellipse", "x^2/4 + y^2 - 1");
  for (const double angle : {0.1, 1., 2., 4.})
    {
      const double       c = std::cos(angle), s = std::sin(angle);
      const Tensor<1, 2> normal({-0.5 * c, -s});
      expect_projection<2>(ellipse, {2. * c, s}, 0., normal / normal.norm());
    }
}

TEST(Obstacles, FunctionFarFromTheOriginIsTheSame)
{
  // What is left is the round-off of the coordinates, 1e-10 at 1e6.
  const LevelSet<2> near("near", "y - 0.1*sin(3*x)"), far("far", "y - 1e6 - 0.1*sin(3*(x - 1e6))");
  const auto expected = near.project({0.3, 0.2}), found = far.project({1e6 + 0.3, 1e6 + 0.2});
  EXPECT_NEAR(found.gap, expected.gap, 1e-9);
  EXPECT_LT((found.normal - expected.normal).norm(), 1e-9);
}

TEST(Obstacles, FunctionIsTheSameInEveryUnit)
{
  const LevelSet<2> metre("metre", "y - 0.1*sin(3*x)"), ball("ball", "1 - x^2 - y^2");
  for (const double unit : {1e-9, 1e9})
    {
      std::ostringstream wave, area;
      wave << "y - 0.1*" << unit << "*sin(3*x/" << unit << ")";
      area << unit << "^2 - x^2 - y^2";
      for (const auto &[original, text] : {std::pair(&metre, wave.str()), {&ball, area.str()}})
        {
          const Point<2> point(0.3, 0.2);
          const auto     expected = original->project(point),
                     found        = LevelSet<2>("scaled", text).project(Point<2>(unit * point));
          EXPECT_NEAR(found.gap / unit, expected.gap, 1e-14) << text;
          EXPECT_LT((found.normal - expected.normal).norm(), 1e-14) << text;
        }
    }
}

TEST(Obstacles, FunctionWithAnEdgeHasTheNormalOfItsSide)
{
  const LevelSet<2> roof("roof", "y + abs(x)");
  for (const double x : {-1., -1e-9, 1e-9, 1.})
    expect_projection<2>(roof,
                         {x, 0.},
                         std::abs(x) / std::sqrt(2.),
                         Tensor<1, 2>({x > 0. ? -1. : 1., -1.}) / std::sqrt(2.));
  expect_projection<2>(roof, {0., 0.3}, 0.3, Tensor<1, 2>({0., -1.}));
}

TEST(Obstacles, NormalPointsAgainstTheGradientOfTheGap)
{
  const Plane<3>         plane(Point<3>(0., 1., 0.), Tensor<1, 3>({1., 2., 3.}));
  const RoundObstacle<3> ball = sphere<3>({2., 0., 0.}, 1.);
  const RoundObstacle<3> pipe(Point<3>(0., 0., 1.), Tensor<1, 3>({1., 2., 2.}), 0.3, false);
  const LevelSet<3>      wave("wave", "z - 0.1*sin(3*x)*cos(2*y)");
  for (const RigidObstacle<3> *obstacle :
       std::initializer_list<const RigidObstacle<3> *>{&plane, &ball, &pipe, &wave})
    {
      const Point<3> point(0.3, 0.2, 0.);
      const auto     projection = obstacle->project(point);
      const double   step       = 1e-5;
      const double   slope      = (obstacle->project(point + step * projection.normal).gap
                            - obstacle->project(point - step * projection.normal).gap)
                           / (2. * step);
      // A function is a distance only to first order; here it is not far from one.
      EXPECT_NEAR(slope, -1., obstacle == &wave ? 0.05 : 1e-9);
    }
}

TEST(Obstacles, FunctionWithoutNormalIsRefused)
{
  const auto message = [](const std::string &text, const Point<2> &point) {
    try
      {
        LevelSet<2>("fog", text).project(point);
      }
    catch (const UserError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  EXPECT_NE(message("1", {0., 0.}).find("does not change"), std::string::npos);
  EXPECT_NE(message("y - sqrt(x)", {0., 1.}).find("has no gradient"), std::string::npos);
  EXPECT_NE(message("y - sqrt(x)", {-1., 1.}).find("is not a finite number"), std::string::npos);
  EXPECT_EQ(message("y - sqrt(x)", {1., 1.}), "");

  const LevelSet<2> root("root", "y - sqrt(x)");
  EXPECT_FALSE(root.try_project({0., 1.}));
  EXPECT_FALSE(root.try_project({-1., 1.}));
  ASSERT_TRUE(root.try_project({1., 1.}));
  EXPECT_EQ(root.try_project({1., 1.})->normal, root.project({1., 1.}).normal);
}

// The condition of a motion says exactly what the gap at its end is, whatever the motion; the gap
// of a motion that turned out to be another one differs by the square of the difference.
TEST(Obstacles, ConditionOfAMotionIsItsGapAtTheEnd)
{
  const Plane<3>         plane(Point<3>(0., 1., 0.), Tensor<1, 3>({1., 2., 3.}));
  const RoundObstacle<3> ball = sphere<3>({2., 0., 0.}, 1.),
                         bowl = sphere<3>({0., 0., 0.}, 1., true);
  const RoundObstacle<3> pipe(Point<3>(0., 0., 1.), Tensor<1, 3>({1., 2., 2.}), 0.3, false);
  const LevelSet<3>      wave("wave", "z - 0.1*sin(3*x)*cos(2*y)");
  const Point<3>         start(0.3, 0.2, 0.1);
  for (const RigidObstacle<3> *obstacle :
       std::initializer_list<const RigidObstacle<3> *>{&plane, &ball, &bowl, &pipe, &wave})
    for (const double size : {0., 1e-12, 1e-6, 1e-3, 0.1})
      for (const Tensor<1, 3> &direction :
           {Tensor<1, 3>({1., 0., 0.}), Tensor<1, 3>({0., 0., -1.}), Tensor<1, 3>({-2., 1., 1.})})
        {
          const Tensor<1, 3> motion    = size * direction;
          const auto         condition = obstacle->condition_of_motion(start, start + motion);
          EXPECT_NEAR(condition.normal.norm(), 1., 1e-14);
          EXPECT_NEAR(
            condition.bound * condition.gap_per_slack, obstacle->project(start).gap, 1e-14);
          EXPECT_NEAR(condition.gap_after(motion), obstacle->project(start + motion).gap, 2e-14);
          // The direction is that in the middle, but for a tilt of second order, and of the
          // order of the gap where that is the distance only near the surface.
          const auto   middle = obstacle->project(start + 0.5 * motion);
          const double off    = obstacle == &wave ? 0.2 * std::abs(middle.gap) : 0.;
          EXPECT_LT((condition.normal - middle.normal).norm(), 1e-12 + 10. * size * size + off);
        }
}

// A point that slides past the edge of a roof would need a normal far from that of any face: the
// plane of the start holds, which is outside of all of the roof.
TEST(Obstacles, ConditionAtAnEdgeIsThePlaneOfTheStart)
{
  const LevelSet<2> roof("roof", "y + abs(x)");
  const Point<2>    start(-0.1, 0.1);
  const auto        condition = roof.condition_of_motion(start, start + Tensor<1, 2>({0.3, 0.}));
  EXPECT_FALSE(condition.is_exact);
  EXPECT_NEAR(condition.bound, roof.project(start).gap, 1e-15);
  EXPECT_LT((condition.normal - roof.project(start).normal).norm(), 1e-15);
}

// Through the middle of a ball there is no way around it: the plane of the start holds.
TEST(Obstacles, ConditionOfAMotionThroughABallHoldsAtTheStart)
{
  const RoundObstacle<2> ball      = sphere<2>({0., 0.}, 1.);
  const auto             condition = ball.condition_of_motion({-1.5, 0.}, {1.5, 0.});
  EXPECT_NEAR(condition.bound, 0.5, 1e-15);
  EXPECT_LT((condition.normal - Tensor<1, 2>({1., 0.})).norm(), 1e-15);
}

// Above a face the distance is the height, beside an edge that to the edge, inside that to the
// nearest face.
TEST(Obstacles, BoxHasFacesEdgesAndAnInside)
{
  const BoxObstacle<2> block({0., 0.}, {4., 2.});
  expect_projection<2>(block, {1., 2.5}, 0.5, Tensor<1, 2>({0., -1.}));
  expect_projection<2>(block, {1., 2.}, 0., Tensor<1, 2>({0., -1.}));
  expect_projection<2>(block, {-3., 1.}, 3., Tensor<1, 2>({1., 0.}));
  expect_projection<2>(block, {7., 6.}, 5., Tensor<1, 2>({-0.6, -0.8}));
  expect_projection<2>(block, {3.5, 1.}, -0.5, Tensor<1, 2>({-1., 0.}));
}

// The place of an obstacle that moves with given rates is their integral; what is seen from a point
// that moves along with it does not change.
TEST(Obstacles, MovedObstacleIsWhereItsMotionTakesIt)
{
  ObstacleMotion<3>::Description description;
  description.velocity         = {{"2*t", "cos(t)", "1"}};
  description.angular_velocity = "3*t^2";
  description.centre           = Point<3>(1., 2., 3.);
  description.axis             = Tensor<1, 3>({2. / 3., -1. / 3., 2. / 3.});
  const auto   motion          = std::make_shared<ObstacleMotion<3>>("box", description);
  const double time            = 0.7;
  const auto   place           = motion->place(time);
  EXPECT_LT((place.displacement - Tensor<1, 3>({time * time, std::sin(time), time})).norm(), 1e-14);
  const auto identity = place.rotation * transpose(place.rotation);
  EXPECT_NEAR(identity.norm(), std::sqrt(3.), 1e-14);
  EXPECT_NEAR(determinant(place.rotation), 1., 1e-14);
  EXPECT_NEAR(trace(place.rotation), 1. + 2. * std::cos(std::pow(time, 3)), 1e-13);
  EXPECT_LT((place.rotation * description.axis - description.axis).norm(), 1e-14);
  // About the axis, by the rule of the right hand.
  const Tensor<1, 3> across({1. / std::sqrt(2.), 0., -1. / std::sqrt(2.)});
  EXPECT_NEAR(cross_product_3d(across, place.rotation * across) * description.axis,
              std::sin(std::pow(time, 3)),
              1e-14);

  MovedObstacle<3> box(
    {"box", std::make_shared<BoxObstacle<3>>(Point<3>(0., 0., 0.), Point<3>(1., 1., 1.)), motion});
  const Point<3> point(2., 0.5, 0.3);
  const auto     before = box.project(point);
  box.move(0., time);
  const auto after = box.project(place.forth(point));
  EXPECT_NEAR(after.gap, before.gap, 1e-14);
  EXPECT_LT((after.normal - place.rotation * before.normal).norm(), 1e-14);
  EXPECT_NEAR(box.project_before(point).gap, before.gap, 1e-15);
}

// A short pulse of the velocity lifts an obstacle once, to where it stays, whatever instants are
// asked for and in which order: integrals that are adaptive from 0 on find the pulse for some ends.
TEST(Obstacles, PulsesOfARateAreNeitherMissedNorForgotten)
{
  ObstacleMotion<2>::Description description;
  description.velocity         = {{"0", "if(t<0.3,0,if(t<0.32,sin(pi*(t-0.3)/0.02),0))"}};
  description.angular_velocity = "if(t<0.3,0,if(t<0.32,1,0))";
  description.panel            = 2e-3;
  const ObstacleMotion<2> motion("table", description);
  const double            lift = 0.04 / dealii::numbers::PI;
  for (const unsigned int k : {999, 160, 151, 1, 77, 500, 499})
    {
      const double time  = 2e-3 * k;
      const double phase = dealii::numbers::PI * (std::clamp(time, 0.3, 0.32) - 0.3) / 0.02;
      EXPECT_NEAR(motion.place(time).displacement[1], lift / 2. * (1. - std::cos(phase)), 1e-12);
      EXPECT_NEAR(motion.place(time).angle, std::clamp(time, 0.3, 0.32) - 0.3, 1e-12);
    }
}

// What is thinner than a hundredth of the way is found, wherever on the way it is; ends do not
// count, nor does what a point slides along, and a chord is as deep as it is.
TEST(Obstacles, ThinObstaclesOnTheWayAreFound)
{
  const auto depth = [](const std::shared_ptr<const RigidObstacle<2>> &shape,
                        const Point<2>                                &start,
                        const Point<2>                                &end) {
    return MovedObstacle<2>({"it", shape}).depth_on_way(start, end, 0.005);
  };
  const auto plate  = std::make_shared<BoxObstacle<2>>(Point<2>(0., -1.), Point<2>(0.05, 1.)),
             needle = std::make_shared<BoxObstacle<2>>(Point<2>(0., -1.), Point<2>(1., 1e-3));
  const auto ball   = std::make_shared<RoundObstacle<2>>(Point<2>(), Tensor<1, 2>(), 0.06, false);
  for (const double start : {-0.01, -0.7, -4.9})
    {
      EXPECT_GT(depth(plate, {start, 0.3}, {start + 5., 0.1}), 0.02);
      EXPECT_GT(depth(ball, {10. * start, 0.03}, {10. * start + 50., 0.03}), 0.025);
      EXPECT_EQ(depth(plate, {start, 2.1}, {start + 5., 2.1}), 0.);
    }
  EXPECT_EQ(depth(plate, {-1., 0.}, {0., 0.}), 0.);
  EXPECT_EQ(depth(needle, {0.1, 1e-3}, {0.9, 1e-3}), 0.);
  EXPECT_NEAR(depth(ball, {-0.06, 0.}, {0., 0.06}), 0.06 * (1. - std::sqrt(0.5)), 1e-3);
}

// The condition of a point beside an obstacle that moves and turns says what the gap is at the end,
// its bound without the motion of the obstacle is the gap of the start, and a point that goes with
// the obstacle keeps its gap.
TEST(Obstacles, ConditionOfAMovedObstacleIsItsGapAtTheEnd)
{
  ObstacleMotion<2>::Description description;
  description.displacement     = {{"0.1*t", "-0.2*t"}};
  description.angular_velocity = "0.5";
  description.centre           = Point<2>(0.2, 0.1);
  const auto motion            = std::make_shared<ObstacleMotion<2>>("it", description);
  const std::vector<std::shared_ptr<const RigidObstacle<2>>> shapes = {
    std::make_shared<Plane<2>>(Point<2>(0., 0.), Tensor<1, 2>({0.6, 0.8})),
    std::make_shared<RoundObstacle<2>>(Point<2>(0.3, -1.), Tensor<1, 2>(), 1., false)};
  const Point<2> start(0.3, 0.1);
  for (const auto &shape : shapes)
    for (const Tensor<1, 2> &d : {Tensor<1, 2>({0.02, -0.01}), Tensor<1, 2>({-0.1, 0.05})})
      {
        MovedObstacle<2> moved({"it", shape, motion});
        moved.move(1., 1.1);
        const auto condition = moved.condition_of_motion(start, start + d);
        EXPECT_NEAR(condition.gap_after(d), moved.project(start + d).gap, 1e-15);
        EXPECT_NEAR(
          condition.gap_after(condition.obstacle_motion), moved.project_before(start).gap, 1e-15);
        const Point<2> along   = motion->place(1.1).forth(motion->place(1.).back(start));
        const auto     carried = moved.condition_of_motion(start, along);
        EXPECT_LT((carried.obstacle_motion - (along - start)).norm(), 1e-15);
        EXPECT_NEAR(carried.gap_after(along - start), moved.project_before(start).gap, 1e-15);
      }
}
