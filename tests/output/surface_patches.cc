// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What the contact surface shows is what the nodes carry, at hanging nodes too: a uniform pressure
// p enters as nodal forces -p D nu and comes back as p; the gap of a tilted bottom is the linear
// function that it is.

#include "box_above_floor.h"

#include <signorini/output/surface_patches.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  template <int dim>
  std::array<std::string, dim> tilt()
  {
    std::array<std::string, dim> displacement;
    displacement[0]       = "0.5";
    displacement[dim - 1] = "-0.05*x";
    return displacement;
  }

  template <int dim>
  void check(const double pressure)
  {
    const BoxAboveFloor<dim> box;
    const auto              &discretization = box.discretization;
    State                    state;
    state.displacement  = discretization.interpolate({tilt<dim>()});
    state.velocity      = discretization.make_vector();
    state.contact_force = discretization.make_vector();
    for (const auto &node : box.surface->nodes())
      for (unsigned int c = 0; c < dim; ++c)
        state.contact_force.local_element(dim * node.node + c) =
          -pressure * node.weight * node.normal()[c];

    SurfacePatches<dim> patches;
    patches.build(discretization,
                  *box.surface,
                  state,
                  discretization.interpolate_hanging_nodes(state.displacement),
                  discretization.interpolate_hanging_nodes(state.velocity));

    // Half of the 2^(dim-1) faces of the bottom are refined.
    const unsigned int half = 1u << (dim - 2);
    EXPECT_EQ(dealii::Utilities::MPI::sum(patches.get_patches().size(), MPI_COMM_WORLD),
              half + half * (1u << (dim - 1)));
    ASSERT_EQ(patches.get_dataset_names().size(), 2 * dim + 3);
    for (const auto &patch : patches.get_patches())
      for (unsigned int v = 0; v < patch.data.n_cols(); ++v)
        {
          const double x = patch.vertices[v][0];
          EXPECT_EQ(patch.vertices[v][dim - 1], 0.);
          EXPECT_NEAR(patch.data(0, v), 0.5, 1e-6);
          EXPECT_NEAR(patch.data(dim - 1, v), -0.05 * x, 1e-6);
          EXPECT_EQ(patch.data(dim, v), 0.);
          EXPECT_NEAR(patch.data(2 * dim, v), pressure, 1e-6);
          EXPECT_NEAR(patch.data(2 * dim + 1, v), 0.1 - 0.05 * x, 1e-6);
          EXPECT_EQ(patch.data(2 * dim + 2, v), pressure > 0. ? 1. : 0.);
        }
  }
} // namespace

TEST(SurfacePatches, UniformPressure)
{
  check<2>(3.);
  check<3>(3.);
}

TEST(SurfacePatches, NoContact)
{
  check<2>(0.);
  check<3>(0.);
}

// Faces of the slave surface that can never touch are shown as open as the most open contact node,
// and without pressure.
TEST(SurfacePatches, FarSideLooksOpen)
{
  Scene<2> scene = box_above_floor<2>();
  scene.pairs[0].slave_boundary_ids.clear();
  const Mesh<2>                mesh(scene.bodies, MPI_COMM_WORLD);
  const Discretization<2>      discretization(mesh);
  const DirichletConditions<2> dirichlet(discretization);
  const ContactSurface<2>      surface(discretization, dirichlet, scene.obstacles, scene.pairs);
  State                        state;
  state.displacement = state.velocity = state.contact_force = discretization.make_vector();

  double largest = 0.;
  for (const auto &node : surface.nodes())
    largest = std::max(largest, node.gap);
  largest = dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);

  SurfacePatches<2> patches;
  const Vector      zero = discretization.interpolate_hanging_nodes(state.displacement);
  patches.build(discretization, surface, state, zero, zero);
  unsigned int on_top = 0;
  for (const auto &patch : patches.get_patches())
    for (unsigned int v = 0; v < 2; ++v)
      if (patch.vertices[v][1] > 1. - 1e-12)
        {
          ++on_top;
          EXPECT_EQ(patch.data(4, v), 0.);
          EXPECT_NEAR(patch.data(5, v), largest, 1e-6);
        }
  EXPECT_GT(dealii::Utilities::MPI::sum(on_top, MPI_COMM_WORLD), 0u);
}
