// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The mass matrix is symmetric and weighs each body: density times the volume of its mesh, which is
// exact for a box, that of the inscribed prism for a cylinder, and second order for a ball. Lumping
// keeps the row sums, hence the mass.

#include "bodies.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double pi = dealii::numbers::PI;

  template <int dim>
  void expect_symmetric_mass(const Discretization<dim> &discretization)
  {
    const Vector x = irregular_field(discretization, 3.), y = irregular_field(discretization, 7.);
    const double xMy = x * mass_times(discretization, y), yMx = y * mass_times(discretization, x);
    EXPECT_GT(x * mass_times(discretization, x), 0.);
    EXPECT_NEAR(xMy, yMx, 1e-13 * std::abs(xMy));
  }

  BodyDescription<3> cylinder(const unsigned int axis)
  {
    BodyDescription<3> body;
    body.name        = "cylinder";
    auto &cylinder   = shape_of<CylinderShape>(body);
    cylinder.centre  = dealii::Point<3>(1., 2., 3.);
    cylinder.radius  = 0.5;
    cylinder.length  = 3.;
    cylinder.axis    = axis;
    body.refinements = 1;
    body.material    = {500., 0.3, 2.};
    return body;
  }
} // namespace

TEST(Mass, OfABoxIsExact)
{
  EXPECT_NEAR(total_mass(Assembled<2>(box<2>(1.5)).discretization), 2. * 1.5 * 1.5, 1e-13);
  EXPECT_NEAR(total_mass(Assembled<3>(box<3>(1.5)).discretization), 2. * 1.5 * 1.5 * 1.5, 1e-13);
}

TEST(Mass, HangingNodesDoNotChangeIt)
{
  const Assembled<2> flat(box_with_hanging_nodes<2>());
  const Assembled<3> solid(box_with_hanging_nodes<3>());
  EXPECT_GT(flat.discretization.hanging_node_constraints().n_constraints(), 0u);
  EXPECT_NEAR(total_mass(flat.discretization), 2., 1e-13);
  EXPECT_NEAR(total_mass(solid.discretization), 2., 1e-13);
  expect_symmetric_mass(flat.discretization);
  expect_symmetric_mass(solid.discretization);
}

TEST(Mass, OfADiscIsThatOfThePolygon)
{
  for (const unsigned int refinements : {1, 2, 3})
    {
      const Assembled<2> disc(ball<2>(refinements));
      EXPECT_NEAR(total_mass(disc.discretization), 2. * polygon_area(4u << refinements), 1e-12);
      expect_symmetric_mass(disc.discretization);
    }
}

TEST(Mass, OfABallConvergesWithSecondOrder)
{
  std::vector<double> error;
  for (const unsigned int refinements : {1, 2, 3})
    error.push_back(8. / 3. * pi - total_mass(Assembled<3>(ball<3>(refinements)).discretization));
  EXPECT_GT(error[2], 0.) << "the vertices are on the sphere, the cells inside of it";
  EXPECT_LT(error[2], 0.02 * 8. / 3. * pi);
  EXPECT_NEAR(error[1] / error[2], 4., 0.2);
  EXPECT_NEAR(error[0] / error[1], 4., 0.4);
}

TEST(Mass, CurvedCellsFollowTheBall)
{
  Scene<3>     scene    = scene_of<3>({ball<3>(2)});
  const double straight = total_mass(Assembled<3>(scene).discretization);
  scene.mapping         = CellGeometry::curved;
  const double curved   = total_mass(Assembled<3>(scene).discretization);
  EXPECT_LT(std::abs(8. / 3. * pi - curved), 0.02 * (8. / 3. * pi - straight));
}

TEST(Mass, OfACylinderIsThatOfThePrismAroundItsAxis)
{
  for (const unsigned int axis : {0, 1, 2})
    {
      const Assembled<3> body(cylinder(axis));
      const auto        &discretization = body.discretization;
      EXPECT_NEAR(total_mass(discretization), 2. * 3. * 0.25 * polygon_area(8), 1e-12)
        << "axis " << axis;
      double extent = 0.;
      for (const auto &position : discretization.node_positions())
        extent =
          std::max(extent, std::abs(position[axis] - body.scene.bodies[0].shape->midpoint()[axis]));
      EXPECT_NEAR(dealii::Utilities::MPI::max(extent, MPI_COMM_WORLD), 1.5, 1e-12)
        << "axis " << axis;
    }
}

TEST(Mass, BodiesDoNotShareNodesWhereTheyTouch)
{
  BodyDescription<2> left = box<2>(), right = box<2>();
  box_of(right).lower_corner = dealii::Point<2>(1., 0.);
  box_of(right).upper_corner = dealii::Point<2>(2., 1.);
  right.material.density     = 5.;
  const Assembled<2> both(scene_of<2>({left, right}));
  EXPECT_EQ(both.discretization.dof_handler().n_dofs(), 2u * 2u * 9u);
  EXPECT_NEAR(total_mass(both.discretization), 2. + 5., 1e-13);
}

TEST(Mass, LumpingGivesTheRowSums)
{
  for (const bool hanging : {false, true})
    {
      Scene<3>           scene = scene_of<3>({hanging ? box_with_hanging_nodes<3>() : ball<3>(1)});
      const Assembled<3> consistent(scene);
      scene.time.mass.kind = MassKind::lumped;
      const Assembled<3> lumped(scene);

      const Vector row_sums =
        mass_times(consistent.discretization, ones(consistent.discretization));
      const Vector factors = irregular_field(lumped.discretization, 3.);
      const Vector product = mass_times(lumped.discretization, factors);
      for (unsigned int i = 0; i < product.locally_owned_size(); ++i)
        EXPECT_NEAR(
          product.local_element(i), row_sums.local_element(i) * factors.local_element(i), 1e-14);
      EXPECT_NEAR(total_mass(lumped.discretization), total_mass(consistent.discretization), 1e-13);
    }
}
