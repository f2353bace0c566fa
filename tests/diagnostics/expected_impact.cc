// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What is expected of an impact before it is computed: Hertz's numbers for a steel ball on a rigid
// plane and for two equal ones, the work of the law of cylinders in the plane, a plane wave for
// flat faces; the curvature, speed and time of the touch come from the distances of the nodes; and
// where bodies meet with an edge or do not meet, nothing is said.

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/diagnostics/expected_impact.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Collider   rigid{infinite, infinite, infinite, infinite, infinite, infinite};

  /** Of radius 10, in mm, t, s. */
  Collider steel_ball()
  {
    const double volume = 4. / 3. * M_PI * 1000.;
    return {7.85e-9 * volume, volume, 210000. / 0.91, 6e6, 7.85e-9, 20.};
  }

  /** With speed 10 and area 1. */
  FirstTouch touch_of_flat_faces()
  {
    FirstTouch touch;
    touch.time      = 0.;
    touch.speed     = 10.;
    touch.is_smooth = true;
    touch.area      = 1.;
    return touch;
  }

  template <int dim>
  FirstTouch first_touch(const Scene<dim> &scene, const double speed)
  {
    const ContactProblem<dim> problem(scene);
    Vector                    displacement = problem.discretization.make_vector();
    Vector                    velocity     = displacement;
    for (unsigned int i = dim - 1; i < velocity.locally_owned_size(); i += dim)
      velocity.local_element(i) = -speed;
    return first_touches(problem.surface, displacement, velocity, MPI_COMM_WORLD).at(0);
  }
} // namespace

TEST(ExpectedImpact, ASteelBallAsHertzSays)
{
  FirstTouch touch;
  touch.time            = 0.;
  touch.speed           = 1000.;
  touch.curvature       = 0.1;
  touch.is_smooth       = true;
  touch.node_spacing    = 0.1;
  ExpectedImpact impact = expected_impact<3>(touch, steel_ball(), rigid);
  EXPECT_NEAR(impact.force, 2309., 1.);
  EXPECT_NEAR(impact.duration, 52.3e-6, 0.1e-6);
  EXPECT_NEAR(impact.n_nodes, M_PI * 4.22 * 4.22, 1.);
  // Two of them: half the mass, modulus, radius and speed of one against a plane are the same
  // motion in a frame that goes with the centre of mass.
  touch.curvature = 0.2;
  touch.speed     = 2000.;
  impact          = expected_impact<3>(touch, steel_ball(), steel_ball());
  EXPECT_NEAR(impact.force, 2309., 1.);
  EXPECT_NEAR(impact.duration, 52.3e-6, 0.1e-6);
}

TEST(ExpectedImpact, OfCylindersIsAsLargeAsTheirEnergy)
{
  // Two steel discs, one of them ten times as soft: the work of F(flattening), integrated, is the
  // energy of the approach, at any speed. Forces are not proportional to speeds.
  const double   mass = 7.85e-9 * M_PI * 100.;
  const Collider stiff{mass, M_PI * 100., 230000., 6e6, 7.85e-9, 20.};
  const Collider soft{mass, M_PI * 100., 23000., 2e6, 7.85e-9, 20.};
  const double   modulus = 1. / (1. / 230000. + 1. / 23000.);
  FirstTouch     touch;
  touch.time            = 0.;
  touch.curvature       = 0.2;
  touch.is_smooth       = true;
  touch.node_spacing    = 0.1;
  const auto flattening = [&](const double force) {
    const double half_width = std::sqrt(4. * force / (0.2 * M_PI * modulus));
    const double L          = 2. * std::log(40. / half_width) - 1.; // 4 R/a
    return force * L / M_PI * (1. / 230000. + 1. / 23000.);
  };
  double of_slow = 0.;
  for (const double speed : {10., 1000., 10000.})
    {
      touch.speed                 = speed;
      const ExpectedImpact impact = expected_impact<2>(touch, stiff, soft);
      constexpr unsigned   n      = 10000;
      double               work   = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double before = impact.force * i / n, after = impact.force * (i + 1) / n;
          const double begin = i == 0 ? 0. : flattening(before);
          work += (before + after) / 2. * (flattening(after) - begin);
        }
      const double energy = 0.5 * mass / 2. * speed * speed;
      EXPECT_NEAR(work, energy, 1e-3 * energy);
      // The impulse of half a sine is that of bodies that part as fast as they met.
      EXPECT_NEAR(2. / M_PI * impact.force * impact.duration, mass * speed, 1e-9 * mass * speed);
      EXPECT_GT(impact.force / speed, 1.1 * of_slow);
      of_slow = impact.force / speed;
    }
}

TEST(ExpectedImpact, AFlatFaceSendsAPlaneWave)
{
  const FirstTouch touch = touch_of_flat_faces();
  // Density 1, wave speed 30, length 10: force rho c v A = 300, duration 2 L/c.
  const Collider bar{10., 10., 900., 30., 1., 10.};
  ExpectedImpact impact = expected_impact<2>(touch, bar, rigid);
  EXPECT_DOUBLE_EQ(impact.force, 300.);
  EXPECT_DOUBLE_EQ(impact.duration, 2. / 3.);
  EXPECT_DOUBLE_EQ(impact.strain, 1. / 3.);
  impact = expected_impact<2>(touch, bar, bar);
  EXPECT_DOUBLE_EQ(impact.force, 150.);
  EXPECT_DOUBLE_EQ(impact.duration, 2. / 3.);
}

TEST(ExpectedImpact, OfABarOnAWideBlockIsThatOnAWall)
{
  const FirstTouch touch = touch_of_flat_faces();
  const Collider   bar{10., 10., 900., 30., 1., 10.};
  // Of a fourth of the impedance, as long, and 400 times as wide: the force and duration of a bar
  // on a wall (300, 2/3) but for one per cent, whichever of the two is named first.
  const Collider block{1000., 4000., 14., 30. / 4., 1., 10.};
  for (const auto &[body, other] : {std::pair(bar, block), std::pair(block, bar)})
    {
      const ExpectedImpact impact = expected_impact<2>(touch, body, other);
      EXPECT_NEAR(impact.force, 300., 3.1);
      EXPECT_DOUBLE_EQ(impact.duration, 2. / 3.);
    }
  EXPECT_NEAR(expected_impact<2>(touch, bar, block).strain, 1. / 3., 0.004);
}

TEST(FirstTouch, OfABallOnAPlane)
{
  const FirstTouch disc = first_touch<2>(contact_scene<2>(ball<2>(5), {floor_at<2>(-0.5)}), 2.);
  EXPECT_TRUE(disc.is_smooth);
  EXPECT_NEAR(disc.time, 0.25, 1e-12);
  EXPECT_NEAR(disc.speed, 2., 1e-12);
  EXPECT_NEAR(disc.curvature, 1., 0.05);
  EXPECT_NEAR(disc.node_spacing, 2. * M_PI / 128., 0.02);
  const FirstTouch sphere = first_touch<3>(contact_scene<3>(ball<3>(4), {floor_at<3>(-0.5)}), 2.);
  EXPECT_TRUE(sphere.is_smooth);
  EXPECT_NEAR(sphere.time, 0.25, 1e-12);
  EXPECT_NEAR(sphere.curvature, 1., 0.1);
}

TEST(FirstTouch, OfFlatFaces)
{
  const FirstTouch alone = first_touch<3>(contact_scene<3>(box<3>(), {floor_at<3>(-0.5)}, {4}), 2.);
  EXPECT_TRUE(alone.is_smooth);
  EXPECT_EQ(alone.curvature, 0.);
  EXPECT_EQ(alone.n_at_once, 9u);
  EXPECT_NEAR(alone.area, 1., 1e-12);
}

TEST(FirstTouch, EdgesAndBodiesThatLeaveAreLeftAlone)
{
  dealii::Point<2>     origin(0., -0.5);
  dealii::Tensor<1, 2> oblique;
  oblique[0]      = 0.3;
  oblique[1]      = 1.;
  const auto ramp = plane<2>("ramp", origin, oblique / oblique.norm());
  EXPECT_FALSE(first_touch<2>(contact_scene<2>(box<2>(), {ramp}, {2}), 2.).is_smooth);
  // A disc beside the end of a plane.
  const std::vector<Plane<2>::End> ends = {{dealii::Point<2>(1., 0.), 1.}};
  const NamedObstacle<2>           table{
    "table",
    std::make_shared<Plane<2>>(dealii::Point<2>(-3., -0.5), dealii::Point<2>(0., 1.), ends)};
  EXPECT_EQ(first_touch<2>(contact_scene<2>(ball<2>(4), {table}), 2.).time, infinite);
  const auto scene = contact_scene<2>(ball<2>(4), {floor_at<2>(-0.5)});
  EXPECT_EQ(first_touch<2>(scene, -2.).time, infinite);
}
