// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Rigid motions that nothing holds: a basis that is orthonormal in the mass, without elastic
// energy, with zeros where entries are held, and of the dimension that counting gives. Every rigid
// motion that leaves the held entries at rest is a combination of them.

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/linear_algebra/vector_kernels.h>
#include <signorini/system/rigid_modes.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  struct Bodies : public ContactProblem<dim>
  {
    explicit Bodies(const Scene<dim> &scene)
      : ContactProblem<dim>(scene)
      , coordinates(this->discretization, this->surface, this->dirichlet)
      , modes(this->discretization, coordinates)
    {
    }

    const ContactCoordinates<dim> coordinates;
    const RigidModes<dim>         modes;
  };

  template <int dim>
  std::vector<Motion> expect_basis(const Bodies<dim>               &bodies,
                                   const std::vector<unsigned int> &held,
                                   const unsigned int               dimension)
  {
    const std::vector<Motion> free = bodies.modes.free_of(held);
    EXPECT_EQ(free.size(), dimension);
    for (unsigned int i = 0; i < free.size(); ++i)
      {
        Vector error = mass_times(bodies.discretization, free[i].displacement);
        error -= free[i].momentum;
        EXPECT_LT(error.linfty_norm(), 1e-13);
        for (unsigned int j = 0; j <= i; ++j)
          EXPECT_NEAR(dot(free[i].momentum, free[j].displacement), i == j ? 1. : 0., 1e-12);
        EXPECT_LT(stiffness_times(bodies.discretization, free[i].displacement).linfty_norm(),
                  1e-13 * bodies.scene.bodies[0].material.youngs_modulus);
        Vector in_frames = free[i].displacement;
        bodies.coordinates.displacement_to_contact(in_frames);
        for (const unsigned int entry : held)
          EXPECT_NEAR(in_frames.local_element(entry), 0., 1e-12);
      }
    return free;
  }

  /** A motion, given body by body, is the combination of the basis. */
  template <int dim>
  void expect_in_span(const Bodies<dim>                               &bodies,
                      const std::vector<Motion>                       &basis,
                      const std::vector<std::array<std::string, dim>> &motion)
  {
    Vector rest = bodies.discretization.interpolate(motion);
    ASSERT_GT(rest.linfty_norm(), 0.1);
    for (const Motion &mode : basis)
      rest.add(-dot(mode.momentum, rest), mode.displacement);
    EXPECT_LT(rest.linfty_norm(), 1e-11);
  }

  template <int dim>
  BodyDescription<dim> cube(const std::string &name, const double bottom, const unsigned int cells)
  {
    dealii::Point<dim> lower, upper;
    for (unsigned int c = 0; c < dim; ++c)
      upper[c] = 1.;
    lower[dim - 1] = bottom;
    upper[dim - 1] = bottom + 1.;
    std::array<unsigned int, dim> repetitions;
    repetitions.fill(cells);
    return block<dim>(name, lower, upper, repetitions);
  }

  template <int dim>
  std::vector<unsigned int> normal_and_tangential_entries(const Bodies<dim> &bodies)
  {
    std::vector<unsigned int> entries = bodies.coordinates.normal_entries();
    for (const auto &tangents : bodies.coordinates.tangential_entries())
      entries.insert(entries.end(), tangents.begin(), tangents.end());
    return entries;
  }

  /** A cube on another one with other cells. @param rotations of 2d (1) or 3d (3) */
  template <int dim>
  void expect_pair(const unsigned int rotations)
  {
    Scene<dim>         scene  = stacked<dim>(cube<dim>("upper", 0., 3), cube<dim>("lower", -1., 2));
    const unsigned int of_one = dim + rotations;
    {
      const Bodies<dim> bodies(scene);
      expect_basis(bodies, {}, 2 * of_one);
      // Closed: one body cannot move away from the other, nor turn about an axis in the face.
      const auto basis =
        expect_basis(bodies, bodies.coordinates.normal_entries(), 2 * of_one - dim);
      std::array<std::string, dim> aside, both;
      aside.fill("0");
      aside[0]      = "1";
      both          = aside;
      both[0]       = dim == 2 ? "-y" : "-z";
      both[dim - 1] = "x";
      expect_in_span<dim>(bodies, basis, {aside, {}});
      expect_in_span<dim>(bodies, basis, {both, both});
    }
    scene.pairs[0].friction.any         = true;
    scene.pairs[0].friction.coefficient = "0.3";
    const Bodies<dim> sticking(scene);
    expect_basis(sticking, normal_and_tangential_entries(sticking), of_one);
  }
} // namespace

TEST(RigidModes, OfFreeBodies)
{
  const Bodies<2> square(scene_of<2>({box_with_hanging_nodes<2>()}));
  expect_in_span<2>(square, expect_basis(square, {}, 3), {{{"0.3 - 0.7*y", "2 + 0.7*x"}}});

  BodyDescription<3> away = ball<3>(2);
  ball_of(away).centre    = {10., -20., 5.};
  const Bodies<3> ball_far_away(scene_of<3>({away}));
  expect_in_span<3>(ball_far_away,
                    expect_basis(ball_far_away, {}, 6),
                    {{{"-0.5*(y + 20)", "0.5*(x - 10) - 0.2*(z - 5)", "1 + 0.2*(y + 20)"}}});
}

TEST(RigidModes, FarFromTheOrigin)
{
  // A rotation is a translation there but for one part in 1e5: orthogonal all the same.
  BodyDescription<3> far = ball<3>(2);
  ball_of(far).centre    = {1e5, -2e5, 5e4};
  const Bodies<3>           bodies(scene_of<3>({far}));
  const std::vector<Motion> free = bodies.modes.free_of({});
  ASSERT_EQ(free.size(), 6u);
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      EXPECT_NEAR(dot(free[i].momentum, free[j].displacement), i == j ? 1. : 0., 1e-13);
}

TEST(RigidModes, OfBodiesThatAreHeld)
{
  // Along the side x = 0; the rotation about x is left in 3d.
  BodyDescription<2> square = box_with_hanging_nodes<2>();
  square.dirichlet          = {{0, {{"0", "-"}}}};
  const Bodies<2> in_2d(scene_of<2>({square}));
  expect_in_span<2>(
    in_2d, expect_basis(in_2d, in_2d.coordinates.dirichlet_entries(), 1), {{{"0", "1"}}});

  BodyDescription<3> cube_3d = box_with_hanging_nodes<3>();
  cube_3d.dirichlet          = {{0, {{"0", "-", "-"}}}};
  const Bodies<3> in_3d(scene_of<3>({cube_3d}));
  expect_in_span<3>(in_3d,
                    expect_basis(in_3d, in_3d.coordinates.dirichlet_entries(), 3),
                    {{{"0", "1 - z", "y - 2"}}});

  square.dirichlet = {{0, {{"0", "0"}}}};
  const Bodies<2> clamped(scene_of<2>({square}));
  expect_basis(clamped, clamped.coordinates.dirichlet_entries(), 0);
}

TEST(RigidModes, AboutANodeThatIsHeld)
{
  const Bodies<2>           bodies(scene_of<2>({box_with_hanging_nodes<2>()}));
  std::vector<unsigned int> corner;
  for (unsigned int node = 0; node < bodies.discretization.matrices().pattern.n_owned; ++node)
    if (bodies.discretization.node_positions()[node].distance(dealii::Point<2>(1., 1.)) < 1e-9)
      corner = {2 * node, 2 * node + 1};
  expect_in_span<2>(bodies, expect_basis(bodies, corner, 1), {{{"1 - y", "x - 1"}}});
}

TEST(RigidModes, OfTwoBodiesInContact)
{
  expect_pair<2>(1);
  expect_pair<3>(3);
}

TEST(RigidModes, AreOfBodiesThatDirichletConditionsDoNotHold)
{
  // The lower body is clamped, another one slides on a plane and turns there, a third one is free.
  Scene<3>           scene  = stacked<3>(cube<3>("upper", 0., 3), cube<3>("lower", -1., 2));
  BodyDescription<3> slider = cube<3>("slider", 5., 2);
  const std::string  free   = "-";
  scene.bodies[1].dirichlet = {{4, {{"0", "0", "0"}}}};
  slider.dirichlet          = {{4, {{free, free, "0"}}}};
  scene.bodies.push_back(slider);
  const Bodies<3> bodies(scene);
  EXPECT_EQ(bodies.modes.bodies(), (std::vector<unsigned int>{0, 2}));
  const auto basis = expect_basis(bodies, bodies.coordinates.dirichlet_entries(), 6 + 3);
  expect_in_span<3>(bodies, basis, {{}, {}, {{"1 - 0.5*y", "0.5*x", "0"}}});

  scene.bodies.erase(scene.bodies.begin() + 2);
  scene.bodies[0].dirichlet = scene.bodies[1].dirichlet;
  const Bodies<3> clamped(scene);
  EXPECT_EQ(clamped.modes.size(), 0U);
  EXPECT_TRUE(clamped.modes.free_of(clamped.coordinates.dirichlet_entries()).empty());
}
