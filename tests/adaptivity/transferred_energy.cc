// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A new mesh brings no energy to bodies that vibrate, whatever would: other points of quadrature in
// cells that are no parallelepipeds, loads that work on what a projection changes, round-off of
// deformations that are tiny compared with displacements. Where standard cells that are straight or
// curved are refined, the function stays and the energy is the old one; where cells are coarsened
// it is that or less. The momentum of free bodies stays. What coarsening takes of products does not
// grow with the mesh.

#include "moving_mesh.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  double energy_of_motion(const State &state)
  {
    return 0.5 * (state.velocity * state.momentum + state.displacement * state.internal_force);
  }

  /** A ball of seven coarse cells, refined once, that vibrates in free flight. */
  template <int dim>
  Scene<dim> vibrating_ball(const CellGeometry geometry)
  {
    BodyDescription<dim> body      = ball<dim>(1);
    body.element                   = ElementKind::standard;
    body.initial_velocity[0]       = "1 + 0.3*sin(2*x)*cos(y)";
    body.initial_velocity[dim - 1] = "-2 + 0.5*cos(3*y + x)";
    Scene<dim> scene               = contact_scene<dim>(body, {floor_at<dim>(-100.)});
    scene.time.scheme              = "contact-stabilized";
    scene.mapping                  = geometry;
    return scene;
  }

  template <int dim>
  void refine_a_ball(const CellGeometry geometry)
  {
    MovingMesh<dim> moving(vibrating_ball<dim>(geometry));
    for (unsigned int step = 0; step < 3; ++step)
      {
        moving.advance(0.05);
        const double energy = moving.total_energy();
        EXPECT_GT(0.5 * (moving.state.displacement * moving.state.internal_force), 1e-3 * energy);
        const Momentum before = momentum(moving.meshed->discretization, moving.state);
        moving.change_at_random(4, 0.3, 0.);
        EXPECT_NEAR(moving.total_energy(), energy, 1e-13 * energy) << step;
        const Momentum after = momentum(moving.meshed->discretization, moving.state);
        for (unsigned int c = 0; c < 3; ++c)
          {
            EXPECT_NEAR(after.linear[c], before.linear[c], 1e-12) << step;
            // Between nodes on an arc rotations are no functions of curved cells.
            const double change = after.angular[c] - before.angular[c];
            EXPECT_NEAR(geometry == CellGeometry::linear ? change : 0., 0., 1e-12) << step;
          }
      }
  }

  /** @return the most that a change of the mesh has brought, in energies of the motion */
  template <int dim>
  double largest_gain(const Scene<dim> &scene, const double step_size, const unsigned int n_steps)
  {
    MovingMesh<dim> moving(scene);
    double          gain = -1., taken = 0.;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        moving.advance(step_size);
        const double energy = moving.total_energy(), scale = energy_of_motion(moving.state);
        moving.change_at_random(3, 0.15, 0.5);
        gain = std::max(gain, (moving.total_energy() - energy) / scale);
        taken += (energy - moving.total_energy()) / scale;
      }
    EXPECT_GT(taken, 1e-6) << "coarsening shall have something to take";
    return gain;
  }
} // namespace

TEST(TransferredEnergy, RefinementOfStraightCells)
{
  refine_a_ball<2>(CellGeometry::linear);
  refine_a_ball<3>(CellGeometry::linear);
}

TEST(TransferredEnergy, RefinementOfCurvedCells)
{
  refine_a_ball<2>(CellGeometry::curved);
  refine_a_ball<3>(CellGeometry::curved);
}

TEST(TransferredEnergy, BallsThatAreCoarsened)
{
  for (const CellGeometry geometry : {CellGeometry::linear, CellGeometry::curved})
    {
      EXPECT_LT(largest_gain(vibrating_ball<2>(geometry), 0.05, 30), 1e-12);
      EXPECT_LT(largest_gain(vibrating_ball<3>(geometry), 0.05, 5), 1e-12);
    }
}

TEST(TransferredEnergy, ProductsOfAProjection)
{
  for (const unsigned int level : {3, 5})
    {
      MovingMesh<2> moving(vibrating_ball<2>(CellGeometry::curved));
      for (unsigned int finer = 1; finer < level; ++finer)
        moving.change_at_random(level, 1., 0.);
      moving.advance(0.05);
      const auto products = [&moving] {
        return moving.meshed->discretization.matrices().products().combined;
      };
      const double        energy = moving.total_energy();
      const unsigned long before = products();
      moving.change_at_random(level, 0., 0.3);
      EXPECT_LT(moving.total_energy(), energy) << "something has to be projected";
      EXPECT_LT(products() - before, 30u) << moving.meshed->discretization.dof_handler().n_dofs();
    }
}

TEST(TransferredEnergy, WorkOfLoadsOnWhatCoarseningChanges)
{
  // Held at its bottom and pulled sideways by more and more towards its top.
  BodyDescription<2>   body = box<2>("box", 0.);
  BoundaryCondition<2> held;
  held.boundary_id      = bottom_id<2>;
  held.expressions      = {{"0", "0"}};
  body.dirichlet        = {held};
  body.body_force       = {{"300*y*y*sin(3*x)", "-200*x*y"}};
  body.initial_velocity = {{"0.1*y", "0.1*y*x"}};
  Scene<2> scene        = contact_scene<2>(body, {floor_at<2>(-100.)}, {top_id<2>});
  scene.time.scheme     = "contact-stabilized";
  EXPECT_LT(largest_gain(scene, 2e-3, 100), 1e-12);
}

TEST(TransferredEnergy, FrictionBetweenBodiesAtLargeCourantNumbers)
{
  // A small block thrown onto a larger one, whose nodes are elsewhere.
  BodyDescription<2> upper = block<2>("upper", {0.1, 0.}, {0.8, 0.6}, {{3, 3}}),
                     lower = block<2>("lower", {0., -1.}, {1., 0.}, {{4, 4}});
  upper.initial_velocity   = {{"0.003 + 0.002*y", "-0.01 + 0.001*x"}};
  for (BodyDescription<2> *body : {&upper, &lower})
    body->element = ElementKind::standard;
  Scene<2> scene                      = stacked<2>(upper, lower);
  scene.time.scheme                   = "contact-stabilized";
  scene.pairs[0].friction.coefficient = "0.3";
  // The Courant number is above 1000 on cells of the first mesh; in 40 steps the bodies move by
  // their size, so that the elastic energy of their tiny deformation has errors of 1e-7 by
  // round-off.
  EXPECT_LT(largest_gain(scene, 4., 40), 1e-12);
}
