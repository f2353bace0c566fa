// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A new mesh does not move a body. A displacement that the coarser mesh cannot represent is
// projected in the energy, which does not see rigid motions. With every change of the mesh
//  - int rho u and int rho X x u of each body stay the same to round-off, because velocities keep
//  the same moments, and the centre of mass goes on from where it was;
//  - what Dirichlet conditions hold stays, the other moments are kept;
//  - nodes that touch an obstacle touch it afterwards, and the body does not move along it;
//  - elastic energy is lost, and never gained.
// A displacement without deformation stays the same function, however many changes there are.

#include "moving_mesh.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  using Expressions = std::vector<std::array<std::string, dim>>;

  template <int dim>
  std::array<std::string, dim> waves()
  {
    if constexpr (dim == 2)
      return {{"0.5 + 0.02*sin(5*x + 1)*cos(3*y)", "-0.3 + 0.03*cos(4*x - 2*y)"}};
    else
      return {{"0.5 + 0.02*sin(5*x + 1)*cos(3*y)",
               "0.2*z + 0.02*sin(4*z - y)",
               "-0.3 - 0.2*y + 0.03*cos(4*x - 2*y)"}};
  }

  /** A state of rest with a displacement on a mesh that is finer than the first one. */
  template <int dim>
  std::unique_ptr<MovingMesh<dim>> displaced(const Scene<dim>       &scene,
                                             const Expressions<dim> &displacement)
  {
    auto moving = std::make_unique<MovingMesh<dim>>(scene);
    for (unsigned int n = 0; n < 3; ++n)
      moving->change_at_random(3, 0.7, 0.);
    State &state       = moving->state;
    state.displacement = moving->meshed->discretization.interpolate(displacement);
    moving->meshed->system.apply_stiffness(state.internal_force, state.displacement);
    return moving;
  }

  /** Moments of the displacement: int rho u, int rho X x u of the part above a height. */
  template <int dim>
  Momentum moments(const MovingMesh<dim> &moving, const double height = -1e9)
  {
    const auto &discretization = moving.meshed->discretization;
    State       state;
    state.momentum = discretization.make_vector();
    discretization.matrices().apply_mass(state.momentum, moving.state.displacement);
    for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
      if (discretization.node_positions()[node][dim - 1] < height)
        for (unsigned int c = 0; c < dim; ++c)
          state.momentum.local_element(dim * node + c) = 0.;
    return momentum(discretization, state);
  }

  double difference(const Momentum &a, const Momentum &b)
  {
    double largest = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      largest = std::max(
        {largest, std::abs(a.linear[c] - b.linear[c]), std::abs(a.angular[c] - b.angular[c])});
    return largest;
  }

  template <int dim>
  double elastic_energy(const MovingMesh<dim> &moving)
  {
    return 0.5 * (moving.state.internal_force * moving.state.displacement);
  }

  template <int dim>
  double largest_gap(const MovingMesh<dim> &moving)
  {
    double largest = 0.;
    for (const double gap : moving.meshed->surface.normal_gap(moving.state.displacement))
      largest = std::max(largest, std::abs(gap));
    return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }

  template <int dim>
  void fly_deformed()
  {
    // Two bodies that do not touch.
    Scene<dim> scene    = stacked<dim>(box<dim>("upper", 0.), box<dim>("lower", -3.));
    scene.time.scheme   = "contact-stabilized";
    auto         moving = displaced<dim>(scene, {waves<dim>(), waves<dim>()});
    const double start  = elastic_energy(*moving);
    double       energy = start, gain = -1., drift = 0.;
    for (unsigned int n = 0; n < (dim == 2 ? 20 : 5); ++n)
      {
        const Momentum both = moments(*moving), upper = moments(*moving, -1.);
        moving->change_at_random(dim == 2 ? 4 : 3, 0.15, 0.5);
        drift = std::max(
          {drift, difference(moments(*moving), both), difference(moments(*moving, -1.), upper)});
        gain   = std::max(gain, elastic_energy(*moving) - energy);
        energy = elastic_energy(*moving);
      }
    EXPECT_LT(drift, 1e-13);
    EXPECT_LT(gain, 1e-12 * start);
    EXPECT_LT(energy, 0.99 * start) << "the displacement shall not fit the coarser meshes";
  }

  /** The undeformed body, far away and turned. */
  template <int dim>
  void stay_rigid()
  {
    Scene<dim> scene =
      contact_scene<dim>(box<dim>("box", 0.), {floor_at<dim>(-1000.)}, {bottom_id<dim>});
    scene.time.scheme                  = "contact-stabilized";
    const Expressions<dim> turned_by_y = {
      dim == 2 ? std::array<std::string, dim>{{"70 - 0.3*y", "-50 + 0.3*x"}} : [] {
        std::array<std::string, dim> result;
        result[0]       = "70 + 0.3*z";
        result[1]       = "20";
        result[dim - 1] = "-50 - 0.3*x";
        return result;
      }()};
    auto moving = displaced<dim>(scene, turned_by_y);
    for (unsigned int n = 0; n < (dim == 2 ? 50 : 10); ++n)
      moving->change_at_random(dim == 2 ? 4 : 3, 0.15, 0.5);
    Vector error = moving->meshed->discretization.interpolate(turned_by_y);
    error -= moving->state.displacement;
    EXPECT_LT(error.linfty_norm(), 1e-11);
  }
} // namespace

TEST(RigidPart, FreeBodiesStayWhereTheyAre)
{
  fly_deformed<2>();
  fly_deformed<3>();
}

TEST(RigidPart, UndeformedBodiesStayUndeformed)
{
  stay_rigid<2>();
  stay_rigid<3>();
}

TEST(RigidPart, DirichletConditionsHold)
{
  // Along a wall: only the motion in y is free.
  BodyDescription<2>   body = box<2>("box", 0.);
  BoundaryCondition<2> wall;
  wall.boundary_id    = 0;
  wall.expressions[0] = "0";
  body.dirichlet      = {wall};
  Scene<2> scene      = contact_scene<2>(body, {floor_at<2>(-100.)}, {bottom_id<2>});
  scene.time.scheme   = "contact-stabilized";
  auto moving         = displaced<2>(scene, {{{"x*sin(3*x + y)", "-20 + 0.3*sin(5*x - y)"}}});
  for (unsigned int n = 0; n < 20; ++n)
    {
      const double before = moments(*moving).linear[1];
      moving->change_at_random(4, 0.15, 0.5);
      EXPECT_NEAR(moments(*moving).linear[1], before, 1e-12);
      Vector in_frames = moving->state.displacement;
      moving->meshed->coordinates.displacement_to_contact(in_frames);
      double largest = 0.;
      for (const unsigned int i : moving->meshed->coordinates.dirichlet_entries())
        largest = std::max(largest, std::abs(in_frames.local_element(i)));
      EXPECT_LT(largest, 1e-13);
    }
}

TEST(RigidPart, ContactStaysClosed)
{
  // Without transverse strain the values at the nodes of a uniform mesh are the projection of
  // functions of one coordinate each. What is left is their mean: kept along the floor, while on
  // the floor closed nodes stay closed.
  BodyDescription<2> body      = box<2>("box", 0.);
  body.material.poissons_ratio = 0.;
  Scene<2> scene               = contact_scene<2>(body, {floor_at<2>(0.)}, {bottom_id<2>});
  scene.time.scheme            = "contact-stabilized";
  MovingMesh<2> moving(scene);
  for (unsigned int n = 0; n < 2; ++n)
    {
      moving.mesh.triangulation().set_all_refine_flags();
      moving.change();
    }
  moving.state.displacement =
    moving.meshed->discretization.interpolate({{{"0.1*x*x", "-0.1*y*y"}}});
  moving.meshed->system.apply_stiffness(moving.state.internal_force, moving.state.displacement);
  const Momentum before = moments(moving);
  for (unsigned int n = 0; n < 2; ++n)
    {
      for (const auto &cell : moving.mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          cell->set_coarsen_flag();
      moving.change();
      EXPECT_LT(largest_gap(moving), 1e-13);
      EXPECT_NEAR(moments(moving).linear[0], before.linear[0], 1e-14);
      EXPECT_GT(std::abs(moments(moving).linear[1] - before.linear[1]), 1e-4);
    }
}
