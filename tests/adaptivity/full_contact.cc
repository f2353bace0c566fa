// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Two blocks under uniform pressure: the discrete solution is exact, every contact node is in full
// contact, and both sides are in balance. The residual estimate must be zero, at rest and of a time
// step, whatever the meshes and whichever block is the slave; it is not zero any more when the
// contact force of one node is taken away.

#include "../contact/stacked_blocks.h"

#include <signorini/adaptivity/contact_fields.h>
#include <signorini/adaptivity/mark_cells.h>
#include <signorini/adaptivity/residual_estimate.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  double sum(const dealii::Vector<double> &squares)
  {
    return dealii::Utilities::MPI::sum(squares.l1_norm(), MPI_COMM_WORLD);
  }

  template <int dim>
  void expect_nothing(const Stack<dim> &stack)
  {
    const TwoBodies<dim> bodies(stack.scene(true), stack.map());
    const auto          &discretization = bodies.discretization;
    State                state;
    state.displacement   = stack.exact(bodies);
    state.velocity       = discretization.make_vector();
    state.contact_force  = uniform_contact_force(bodies);
    const double energy  = state.displacement * stiffness_times(discretization, state.displacement);
    const auto   squares = [&](const ForceBalance &balance, const double step_size) {
      return ResidualEstimate(discretization, bodies.surface, bodies.dirichlet)
        .squares(balance, ResidualWeights{step_size});
    };
    const ForceBalance rest =
      balance_at_rest(discretization, bodies.surface, state.displacement, state.contact_force);
    EXPECT_LT(sum(squares(rest, 0.)), 1e-20 * energy);
    for (const double tau : {1e-3, 1.})
      EXPECT_LT(
        sum(squares(
          balance_of_step(discretization, bodies.surface, {state, state, tau}, TimeIntegration()),
          tau)),
        1e-20 * energy);

    // Without the forces the pressure is a residual on both sides: 2 h p^2 / mu over the common
    // face, or more.
    ForceBalance unbalanced  = rest;
    unbalanced.contact_force = 0.;
    EXPECT_GT(sum(squares(unbalanced, 0.)), 1e-3 * energy);

    // All cells at the interface are in contact, and none that are far away.
    const auto   contact = cells_in_contact(discretization, bodies.surface, state.contact_force);
    unsigned int wrong   = 0;
    for (const auto &cell : discretization.mesh().triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          double distance = height;
          for (const unsigned int v : cell->vertex_indices())
            distance = std::min(distance, std::abs(cell->vertex(v)[dim - 1] - lower_height));
          wrong += contact[cell->active_cell_index()] ? distance > 0.3 : distance < 1e-9;
        }
    EXPECT_EQ(wrong, 0u);
  }
} // namespace

TEST(FullContact, NoErrorIn2d)
{
  auto reversed = stack<2>({{5, 2}}, {{3, 4}}, std::sqrt(2.));
  expect_nothing(reversed);
  reversed.lower_is_slave = true;
  expect_nothing(reversed);
  auto distorted         = stack<2>({{7, 3}}, {{3, 4}}, 1.);
  distorted.is_distorted = true;
  expect_nothing(distorted);
}

TEST(FullContact, NoErrorIn3dWithHangingNodes)
{
  auto both = stack<3>({{3, 3, 2}}, {{2, 2, 2}}, 1.);
  for (auto *body : {&both.upper, &both.lower})
    {
      body->local_refinements = 1;
      body->refine_where      = "0.7 - x - 0.5*y";
    }
  expect_nothing(both);
  both.lower_is_slave = true;
  expect_nothing(both);
}

// Nodes around an open one are in semi-contact: their normal stress counts, and so does the
// pressure times the gap.
TEST(FullContact, AnOpenNodeMakesItsNeighboursSemiContact)
{
  const auto         blocks = stack<2>({{4, 2}}, {{4, 2}}, 1.);
  const TwoBodies<2> bodies(blocks.scene(true));
  const Vector       u = blocks.exact(bodies);
  ForceBalance       balance =
    balance_at_rest(bodies.discretization, bodies.surface, u, uniform_contact_force(bodies));
  std::vector<double> forces(bodies.surface.nodes().size());
  Vector              force = bodies.discretization.make_vector();
  for (std::size_t k = 0; k < forces.size(); ++k)
    {
      const ContactNode<2> &node      = bodies.surface.nodes()[k];
      const bool            is_middle = std::abs(node.position[0] - 0.5) < 1e-9;
      force.local_element(bodies.coordinates.normal_entries()[k]) =
        is_middle ? 0. : -pressure * node.weight;
      balance.gap[k] = is_middle ? 0.01 : 0.;
    }
  bodies.coordinates.force_to_cartesian(force);
  balance.contact_force = force;
  const auto fields     = contact_fields(bodies.discretization,
                                     bodies.surface,
                                     bodies.dirichlet,
                                     balance,
                                     bodies.discretization.interpolate_hanging_nodes(u));
  for (const ContactNode<2> &node : bodies.surface.nodes())
    EXPECT_EQ(fields.open.local_element(2 * node.node),
              std::abs(node.position[0] - 0.5) < 0.3 ? 1. : 0.)
      << node.position;
  const auto squares = ResidualEstimate(bodies.discretization, bodies.surface, bodies.dirichlet)
                         .squares(balance, ResidualWeights{});
  double by_gap =
    0.; // of the cells of the slave next to the open node: normal stress p on half, and s gap
  for (const auto &cell : bodies.discretization.mesh().triangulation().active_cell_iterators())
    if (cell->is_locally_owned() && cell->material_id() == 0)
      by_gap += squares(cell->active_cell_index());
  by_gap = dealii::Utilities::MPI::sum(by_gap, MPI_COMM_WORLD);
  // Two faces of the size 1/4 with `open` = 1 at both ends and two with one end: p^2 h / mu (2 + 1)
  // h; s gap: 2 p 0.01 h / 6.
  const double h = 0.25, mu = blocks.upper.material.mu();
  EXPECT_NEAR(by_gap, 3. * pressure * pressure * h * h / mu + 2. * pressure * 0.01 * h / 6., 1e-8);
}
