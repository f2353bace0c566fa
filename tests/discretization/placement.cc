// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A rotated and translated body is the body somewhere else: same volume, same boundary ids, and
// refinement puts new vertices on its round surfaces where they are now.

#include "shapes.h"

#include <signorini/model/placed_body.h>

#include <gtest/gtest.h>

#include <set>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** About a point that is not the centre of any body here. */
  template <int dim>
  Placement<dim> somewhere()
  {
    Point<dim>     centre;
    Tensor<1, dim> translation;
    centre[0]      = 0.7;
    centre[1]      = -0.3;
    translation[1] = 5.;
    std::array<double, Placement<dim>::n_angles> degrees;
    degrees.fill(25.);
    return Placement<dim>(degrees, centre, translation);
  }

  template <int dim>
  std::vector<Point<dim>> vertices_of(const BodyDescription<dim> &body)
  {
    return Meshed<dim>(body).triangulation.get_vertices();
  }

  BodyDescription<3> lying_cylinder(const unsigned int axis)
  {
    BodyDescription<3> body;
    body.name        = "cylinder";
    auto &cylinder   = shape_of<CylinderShape>(body);
    cylinder.centre  = Point<3>(1., 2., 3.);
    cylinder.radius  = 0.5;
    cylinder.length  = 3.;
    cylinder.axis    = axis;
    body.refinements = 2;
    return body;
  }
} // namespace

TEST(Placement, ZeroRotationLeavesEveryDigit)
{
  BodyDescription<3> brick   = box<3>(0.7);
  box_of(brick).lower_corner = Point<3>(-0.1, 0.3, 1. / 3.);
  for (BodyDescription<3> body : {brick, ball<3>(2), lying_cylinder(1)})
    {
      body.refinements                    = 2;
      const std::vector<Point<3>> without = vertices_of(body);
      body.placement = Placement<3>({{0., 360., 0.}}, Point<3>(0.3, 0.9, -1.1), Tensor<1, 3>());
      const std::vector<Point<3>> with_placing = vertices_of(body);
      EXPECT_EQ(without, with_placing) << body.name;
      EXPECT_GT(without.size(), 0u);
    }
}

TEST(Placement, AQuarterTurnOfABoxIsExact)
{
  // Stands on x, lies afterwards along -z: faces stay exactly in planes, and keep their ids.
  BodyDescription<3> body = box<3>(0.7);
  body.refinements        = 2;
  body.placement          = Placement<3>({{0., 90., 0.}}, Point<3>(), Tensor<1, 3>({0., 0., 4.}));
  const Meshed<3> meshed(body);
  unsigned int    n_faces = 0;
  for_boundary_vertices(meshed.triangulation, [&](const Point<3> &vertex, const unsigned int id) {
    const double expected[6][2] = {{2, 4.}, {2, 4. - 0.7}, {1, 0.}, {1, 0.7}, {0, 0.}, {0, 0.7}};
    EXPECT_EQ(vertex[static_cast<unsigned int>(expected[id][0])], expected[id][1])
      << "boundary id " << id;
    ++n_faces;
  });
  EXPECT_EQ(dealii::Utilities::MPI::sum(n_faces, MPI_COMM_WORLD), 4u * 6u * 64u);
  EXPECT_NEAR(volume(meshed.triangulation), 0.7 * 0.7 * 0.7, 1e-14);
}

template <int dim>
void check_ball()
{
  BodyDescription<dim> body     = ball<dim>(3);
  const double         expected = volume(Meshed<dim>(body).triangulation);
  body.placement                = somewhere<dim>();
  const Point<dim>  centre      = centre_of(body);
  const Meshed<dim> meshed(body);
  EXPECT_NEAR(volume(meshed.triangulation), expected, 1e-12);
  EXPECT_GT(centre.distance(body.shape->midpoint()), 4.);
  for_boundary_vertices(meshed.triangulation, [&](const Point<dim> &vertex, const unsigned int) {
    EXPECT_NEAR(vertex.distance(centre), 1., 1e-14);
  });
}

TEST(Placement, ARefinedBallIsRoundAboutItsNewCentre)
{
  check_ball<2>();
  check_ball<3>();
}

TEST(Placement, ARefinedCylinderIsRoundAboutItsNewAxis)
{
  for (const unsigned int axis : {0, 1, 2})
    {
      BodyDescription<3> body     = lying_cylinder(axis);
      const double       expected = volume(Meshed<3>(body).triangulation);
      body.placement              = somewhere<3>();
      const Point<3> centre       = centre_of(body);
      Tensor<1, 3>   direction;
      direction[axis] = 1.;
      direction       = body.placement.turn(direction);
      EXPECT_LT(std::abs(direction[axis]), 0.95) << "it is turned";
      const Meshed<3> meshed(body);
      EXPECT_NEAR(volume(meshed.triangulation), expected, 1e-12);
      for_boundary_vertices(
        meshed.triangulation, [&](const Point<3> &vertex, const unsigned int id) {
          const double along = (vertex - centre) * direction;
          if (id == 0)
            {
              EXPECT_NEAR((vertex - centre - along * direction).norm(), 0.5, 1e-13);
            }
          else
            {
              EXPECT_NEAR(along, id == 1 ? -1.5 : 1.5, 1e-13);
            }
        });
    }
}

TEST(Placement, LocalRefinementLooksWhereTheBodyIs)
{
  BodyDescription<2> body = box<2>();
  body.placement          = Placement<2>({{90.}}, Point<2>(), Tensor<1, 2>());
  body.local_refinements  = 1;
  body.refine_where       = "-0.5 - x"; // the box fills -1 < x < 0 now
  EXPECT_EQ(Meshed<2>(body).triangulation.n_global_active_cells(), 2u + 2u * 4u);
  body.refine_where = "x - 0.5";
  EXPECT_EQ(Meshed<2>(body).triangulation.n_global_active_cells(), 4u);
}

// A selection that shrinks with the cells makes layers that become thinner: of 2 x 2 cells the left
// column is refined, then the left half of that, then the left quarter. 2 + 4 + 8 + 32 cells are
// left.
TEST(Placement, LocalRefinementCanDependOnTheSizeOfCells)
{
  BodyDescription<2> body  = box<2>();
  box_of(body).repetitions = {{2, 2}};
  body.local_refinements   = 3;
  body.refine_where        = "1.2*h - x";
  EXPECT_EQ(Meshed<2>(body).triangulation.n_global_active_cells(), 2u + 4u + 8u + 32u);
}

TEST(Placement, HowLongABodyIsAndHowSlowlyItVibratesDependsOnNoAxes)
{
  const double wave_speed = box<2>().material.pressure_wave_speed();
  double       of_disc    = 0.;
  for (const double degrees : {0., 17., 45., 90.})
    {
      BodyDescription<2> plank = box<2>(), disc = ball<2>(2);
      box_of(plank).upper_corner = Point<2>(3., 0.5);
      BodyDescription<3> brick   = box<3>();
      box_of(brick).upper_corner = Point<3>(1., 4., 2.);
      const double   angle       = degrees * M_PI / 180.;
      const Point<2> centre(-50., 20.);
      plank.placement = disc.placement = Placement<2>({{degrees}}, centre, Tensor<1, 2>());
      brick.placement = Placement<3>({{degrees, 0., degrees}}, Point<3>(), Tensor<1, 3>());
      const Mesh<2> planar({plank, disc}, MPI_COMM_WORLD);
      const Mesh<3> solid({brick}, MPI_COMM_WORLD);
      Tensor<1, 2>  along;
      along[0] = std::cos(angle);
      along[1] = std::sin(angle);
      EXPECT_NEAR(planar.lowest_frequency(0), wave_speed / 3., 1e-9);
      // The coarse cells of a disc fill a square, and trapezoids are no parallelepipeds.
      EXPECT_NEAR(planar.lowest_frequency(1), wave_speed / std::sqrt(2.), 0.05 * wave_speed);
      if (degrees == 0.)
        of_disc = planar.lowest_frequency(1);
      EXPECT_NEAR(planar.lowest_frequency(1), of_disc, 1e-9);
      EXPECT_NEAR(
        solid.lowest_frequency(0), solid.bodies()[0].material.pressure_wave_speed() / 4., 1e-9);
      EXPECT_NEAR(planar.extent(0, along), 3., 1e-9);
      EXPECT_NEAR(planar.extent(1, along), 2., 0.04) << "a polygon";
    }
}
