// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// With friction the contact surface shows what the nodes carry and how far they slid, at hanging
// nodes too, where fields that are linear come back as they are; before the first step, when the
// state knows no friction, the fields are there and zero.

#include "box_above_floor.h"

#include <signorini/output/surface_patches.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  constexpr double pressure = 3., end_of_sticking = 0.6;

  /**
   * Nodes on one side stick. Hanging nodes lie between those that do and between those of which
   * one does not.
   */
  template <int dim>
  bool sticks(const dealii::Point<dim> &position)
  {
    return position[dim - 2] < end_of_sticking;
  }

  /** A uniform pressure with a shear of half of it. */
  template <int dim>
  State sliding_state(const BoxAboveFloor<dim> &box)
  {
    State state;
    state.displacement = state.velocity = state.contact_force = box.discretization.make_vector();
    FrictionState &friction                                   = state.friction;
    friction.force = friction.slip = friction.accumulated_slip = state.contact_force;
    for (const auto &node : box.surface->nodes())
      {
        state.contact_force.local_element(dim * node.node + dim - 1) = pressure * node.weight;
        friction.force.local_element(dim * node.node)                = 0.5 * pressure * node.weight;
        friction.accumulated_slip.local_element(dim * node.node)     = 0.2 + 0.1 * node.position[0];
        friction.slip.local_element(dim * node.node + dim - 2) = -0.01 * node.position[dim - 2];
        friction.slip_path.push_back(1.);
        friction.status.push_back(sticks<dim>(node.position) ? contact_status::stick
                                                             : contact_status::slip);
      }
    return state;
  }

  template <int dim>
  std::vector<typename SurfacePatches<dim>::Patch> patches_of(const BoxAboveFloor<dim> &box,
                                                              const State              &state)
  {
    SurfacePatches<dim> patches;
    const Vector        zero =
      box.discretization.interpolate_hanging_nodes(box.discretization.make_vector());
    patches.build(box.discretization, *box.surface, state, zero, zero);
    EXPECT_EQ(patches.get_dataset_names().size(), 5 * dim + 3);
    return patches.get_patches();
  }

  constexpr unsigned int first_vector(const unsigned int dim)
  {
    return 2 * dim + 3;
  }

  template <int dim>
  void check_sliding()
  {
    const BoxAboveFloor<dim> box(true);
    for (const auto &patch : patches_of(box, sliding_state(box)))
      for (unsigned int v = 0; v < patch.data.n_cols(); ++v)
        {
          const dealii::Point<dim> x      = patch.vertices[v];
          const auto               vector = [&](const unsigned int i, const unsigned int c) {
            return patch.data(first_vector(dim) + i * dim + c, v);
          };
          EXPECT_NEAR(patch.data(2 * dim, v), pressure, 1e-6);
          EXPECT_EQ(patch.data(2 * dim + 2, v), sticks<dim>(x) ? 2. : 1.) << x;
          EXPECT_NEAR(vector(0, 0), 0.5 * pressure, 1e-6) << x;
          EXPECT_NEAR(vector(1, 0), 0.2 + 0.1 * x[0], 1e-6) << x;
          EXPECT_NEAR(vector(2, dim - 2), -0.01 * x[dim - 2], 1e-6) << x;
          for (unsigned int i = 0; i < 3; ++i)
            EXPECT_EQ(vector(i, dim - 1), 0.);
        }
  }

  template <int dim>
  void check_start()
  {
    const BoxAboveFloor<dim> box(true);
    State                    state = sliding_state(box);
    state.friction                 = FrictionState();
    for (const auto &patch : patches_of(box, state))
      for (unsigned int v = 0; v < patch.data.n_cols(); ++v)
        {
          EXPECT_EQ(patch.data(2 * dim + 2, v), 1.);
          for (unsigned int i = first_vector(dim); i < patch.data.n_rows(); ++i)
            EXPECT_EQ(patch.data(i, v), 0.);
        }
  }
} // namespace

TEST(SurfaceFriction, Sliding)
{
  check_sliding<2>();
  check_sliding<3>();
}

TEST(SurfaceFriction, BeforeTheFirstStep)
{
  check_start<2>();
  check_start<3>();
}

// A node without pressure is open, whatever it did when it was last touched.
TEST(SurfaceFriction, OpenWithoutPressure)
{
  const BoxAboveFloor<2> box(true);
  State                  state = sliding_state(box);
  state.contact_force          = 0.;
  for (const auto &patch : patches_of(box, state))
    for (unsigned int v = 0; v < patch.data.n_cols(); ++v)
      EXPECT_EQ(patch.data(2 * 2 + 2, v), 0.);
}
