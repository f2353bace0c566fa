// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A new mesh is no force. The mesh is refined and coarsened at random in every one of 200 steps:
//
// - In free flight of a body that vibrates, momentum stays the same to round-off, since velocities
//   are projected in the mass matrix and constants are in every space; no contact force appears;
//   the transfer takes energy and never brings any (projections in the norms of energy), and what
//   it takes is booked, so that the ledger closes.
// - A body, or a stack of two with friction, that is pressed on a plane has a displacement that
//   every mesh represents; it stays, with the same contact force, and nothing starts to move. The
//   solver finds contact where it was.
//
// Of a body that flies without deformation the velocity is the first guess. It leaves the round-off
// of stiffness times displacement: nothing to solve, or where that is near to what is accepted, an
// iteration.

#include "moving_mesh.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  void fly()
  {
    BodyDescription<dim> body      = box<dim>("box", 0.);
    body.initial_velocity[0]       = "1 + 0.3*sin(2*x)*cos(y)";
    body.initial_velocity[dim - 1] = "-2 + 0.5*cos(3*y + x)";
    Scene<dim> scene  = contact_scene<dim>(body, {floor_at<dim>(-100.)}, {bottom_id<dim>});
    scene.time.scheme = "contact-stabilized";
    MovingMesh<dim> moving(scene);
    const double    energy           = moving.total_energy();
    double          largest_transfer = -1., largest_residual = 0., taken = 0., momentum_change = 0.,
           force         = 0.;
    unsigned long fewest = 1000000, most = 0;
    for (unsigned int step = 0; step < (dim == 2 ? 200 : 40); ++step)
      {
        const Momentum before = momentum(moving.meshed->discretization, moving.state);
        moving.change_at_random(dim == 2 ? 4 : 3, 0.15, 0.5);
        const Momentum after = momentum(moving.meshed->discretization, moving.state);
        for (unsigned int c = 0; c < 3; ++c)
          momentum_change = std::max({momentum_change,
                                      std::abs(after.linear[c] - before.linear[c]),
                                      std::abs(after.angular[c] - before.angular[c])});
        const EnergyBooking booking = moving.advance(2e-3);
        largest_transfer            = std::max(largest_transfer, booking.transfer);
        taken -= booking.transfer;
        largest_residual   = std::max(largest_residual, std::abs(booking.residual));
        force              = std::max(force, moving.state.contact_force.linfty_norm());
        const auto n_cells = moving.mesh.triangulation().n_global_active_cells();
        fewest             = std::min<unsigned long>(fewest, n_cells);
        most               = std::max<unsigned long>(most, n_cells);
      }
    EXPECT_GT(most, 2 * fewest) << "the mesh shall change";
    EXPECT_LT(momentum_change, 1e-13);
    EXPECT_EQ(force, 0.);
    EXPECT_LT(largest_transfer, 1e-12 * energy);
    EXPECT_GT(taken, 1e-6 * energy) << "coarsening shall have something to take";
    EXPECT_LT(largest_residual, 1e-10 * energy);
  }

  /** Displacement of a block under pressure p on its top, free at its sides, and its expressions.
   */
  template <int dim>
  std::array<std::string, dim>
  uniform_compression(const Material &material, const double p, const double height)
  {
    const double                 E = material.youngs_modulus, nu = material.poissons_ratio;
    const double                 down   = dim == 3 ? p / E : (1. - nu * nu) / E * p;
    const double                 aside  = dim == 3 ? nu * p / E : nu * (1. + nu) / E * p;
    const char *const            axes[] = {"x", "y", "z"};
    std::array<std::string, dim> result;
    for (unsigned int c = 0; c + 1 < dim; ++c)
      result[c] = std::to_string(1e9 * aside) + "e-9*" + axes[c];
    result[dim - 1] = "-" + std::to_string(1e9 * down) + "e-9*(" + axes[dim - 1] + "+"
                      + std::to_string(height) + ")";
    return result;
  }

  template <int dim>
  void press(const bool two_bodies)
  {
    constexpr double       pressure = 3.;
    BodyDescription<dim>   upper = box<dim>("upper", 0.), lower = box<dim>("lower", -1.);
    const double           height = two_bodies ? 1. : 0.;
    BoundaryCondition<dim> load;
    load.boundary_id           = top_id<dim>;
    load.expressions[dim - 1]  = "-3";
    upper.traction             = {load};
    upper.initial_displacement = uniform_compression<dim>(upper.material, pressure, height);
    lower.initial_displacement = uniform_compression<dim>(upper.material, pressure, height);
    Scene<dim> scene           = two_bodies ? stacked<dim>(upper, lower) : scene_of<dim>({upper});
    scene.obstacles            = {floor_at<dim>(-height)};
    PairDescription on_floor;
    on_floor.name               = "bottom : floor";
    on_floor.slave              = two_bodies ? 1 : 0;
    on_floor.slave_boundary_ids = {bottom_id<dim>};
    on_floor.obstacle           = 0;
    scene.pairs.push_back(on_floor);
    scene.time.scheme = "contact-stabilized";
    MovingMesh<dim> moving(scene);
    const double    energy             = std::abs(moving.total_energy());
    double          displacement_error = 0., velocity = 0., force_error = 0., largest_transfer = 0.,
           residual                     = 0.;
    unsigned int       most_active_sets = 0;
    const unsigned int n_steps          = dim == 2 ? 200 : 20;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        moving.change_at_random(dim == 2 ? 4 : 3, 0.15, 0.5);
        const EnergyBooking booking = moving.advance(1e-2);
        largest_transfer            = std::max(largest_transfer, std::abs(booking.transfer));
        residual                    = std::max(residual, std::abs(booking.residual));
        std::vector<std::array<std::string, dim>> exact;
        for (const auto &body : moving.scene.bodies)
          exact.push_back(body.initial_displacement);
        Vector error = moving.meshed->discretization.interpolate(exact);
        error -= moving.state.displacement;
        displacement_error = std::max(displacement_error, error.linfty_norm());
        velocity           = std::max(velocity, moving.state.velocity.linfty_norm());
        if (step > 0) // at the start nothing is known about contact
          most_active_sets = std::max(most_active_sets, moving.effort.active_set_iterations);
        const ContactSummary contact =
          contact_summary(moving.meshed->surface, moving.meshed->discretization, moving.state);
        force_error =
          std::max(force_error, std::abs(contact.normal_force - (two_bodies ? 2. : 1.) * pressure));
      }
    EXPECT_LT(displacement_error, 1e-9);
    EXPECT_LT(velocity, 1e-9);
    EXPECT_LT(force_error, 1e-6);
    EXPECT_LT(largest_transfer, 1e-11 * energy);
    EXPECT_LT(residual, 1e-10 * energy);
    EXPECT_LE(most_active_sets, 2u)
      << "contact is where it was: one look and another one that confirms it";
  }

  template <int dim>
  void fly_rigidly()
  {
    BodyDescription<dim> body = box<dim>("box", 0.);
    body.initial_velocity[0]  = "1.5";
    body.initial_velocity[1]  = "-2";
    Scene<dim> scene          = contact_scene<dim>(body, {floor_at<dim>(-100.)}, {bottom_id<dim>});
    scene.time.scheme         = "contact-stabilized";
    MovingMesh<dim> moving(scene);
    const double    energy = moving.total_energy();
    for (unsigned int step = 0; step < 10; ++step)
      {
        moving.change_at_random(dim == 2 ? 4 : 3, 0.15, 0.5);
        moving.advance(2e-3);
        EXPECT_LE(moving.effort.linear_iterations, 1u) << "step " << step;
        const Discretization<dim> &discretization = moving.meshed->discretization;
        Vector error = discretization.interpolate({moving.scene.bodies[0].initial_velocity});
        error -= moving.state.velocity;
        EXPECT_LT(error.linfty_norm(), 1e-10) << "step " << step;
      }
    EXPECT_NEAR(moving.total_energy(), energy, 1e-12 * energy);
  }
} // namespace

TEST(RandomMeshes, FreeFlight2d)
{
  fly<2>();
}
TEST(RandomMeshes, FreeFlight3d)
{
  fly<3>();
}
TEST(RandomMeshes, RigidFlight)
{
  fly_rigidly<2>();
  fly_rigidly<3>();
}
TEST(RandomMeshes, PressedOnAPlane2d)
{
  press<2>(false);
}
TEST(RandomMeshes, PressedOnAPlane3d)
{
  press<3>(false);
}
TEST(RandomMeshes, PressedStack2d)
{
  press<2>(true);
}
TEST(RandomMeshes, PressedStack3d)
{
  press<3>(true);
}
