// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What a state knows about friction is added up over the nodes that carry a force and shown by
// probes: tangential forces next to the normal ones, never among them; slips as lengths, that is,
// over the transmission of a node; and nothing at all without friction.

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/diagnostics/friction_reading.h>
#include <signorini/diagnostics/pair_contact.h>
#include <signorini/diagnostics/probe.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** A unit square with three contact nodes at a floor, which presses on two of them. */
  struct SlidingSquare
  {
    SlidingSquare()
      : problem(contact_scene<2>(box<2>(), {floor_at<2>(0.)}, {2}))
    {
      const auto &discretization = problem.discretization;
      state.displacement = state.velocity = state.momentum = state.internal_force =
        state.contact_force                                = discretization.make_vector();
      auto &friction                                       = state.friction;
      friction.force = friction.slip = friction.accumulated_slip = discretization.make_vector();
      // Out of contact: it stuck, and has slid before.
      set(0., 0., 0., contact_status::stick, 0.04, 0.3);
      set(0.5, 3., -0.6, contact_status::stick, -0.01, 0.02);
      set(1., 1., 0.4, contact_status::slip, -0.03, 0.07);
    }

    /** Values of the node at x: forces on the body, upwards and to the right, and its slip. */
    void set(double x, double pressure, double shear, char status, double slip, double path)
    {
      auto &friction = state.friction;
      friction.slip_path.resize(problem.surface.nodes().size());
      friction.status.resize(problem.surface.nodes().size());
      for (unsigned int k = 0; k < problem.surface.nodes().size(); ++k)
        if (const ContactNode<2> &node = problem.surface.nodes()[k]; node.position[0] == x)
          {
            state.contact_force.local_element(2 * node.node)       = shear;
            state.contact_force.local_element(2 * node.node + 1)   = pressure;
            friction.force.local_element(2 * node.node)            = shear;
            friction.slip.local_element(2 * node.node)             = slip / 10.;
            friction.accumulated_slip.local_element(2 * node.node) = slip;
            friction.slip_path[k]                                  = path;
            friction.status[k]                                     = status;
          }
    }

    const ContactProblem<2> problem;
    State                   state;
  };

  /**
   * An edge of the slave is prescribed, so that some nodes have no multiplier and others take their
   * share.
   */
  Scene<3> blocks_with_shares()
  {
    auto slave      = block<3>("slave", {0., 0., 0.}, {1., 1., 1.}, {{2, 3, 1}});
    slave.dirichlet = {{2, {{"-", "-", "0"}}}};
    return stacked<3>(slave, block<3>("master", {0.45, -0.3, -1.}, {1.7, 0.8, -0.05}, {{3, 2, 2}}));
  }
} // namespace

TEST(FrictionSummary, CountsNodesThatCarryAForce)
{
  const SlidingSquare  square;
  const ContactSummary summary =
    contact_summary(square.problem.surface, square.problem.discretization, square.state);
  EXPECT_DOUBLE_EQ(summary.normal_force, 4.);
  EXPECT_DOUBLE_EQ(summary.friction_force, 1.);
  EXPECT_DOUBLE_EQ(summary.resultant[0], -0.2);
  EXPECT_DOUBLE_EQ(summary.resultant[1], 4.);
  EXPECT_EQ(summary.n_active, 2u);
  EXPECT_EQ(summary.n_stick, 1u);
  EXPECT_EQ(summary.n_slip, 1u);
  EXPECT_DOUBLE_EQ(summary.max_slip, 0.3) << "the way of a node counts when it has left, too";
}

// What solvers leave at a node that is just open differs between one process and two.
TEST(FrictionSummary, RoundOffIsNoForceOfANode)
{
  SlidingSquare square;
  const auto    counts = [&](const double force) {
    square.set(0.5, force, 0., contact_status::stick, 0., 0.);
    const ContactSummary summary =
      contact_summary(square.problem.surface, square.problem.discretization, square.state);
    const PairContact pair =
      PairReader<2>(square.problem.discretization, square.problem.surface).read(square.state)[0];
    EXPECT_EQ(pair.n_active, summary.n_active);
    EXPECT_EQ(summary.n_stick, summary.n_active - 1);
    return summary.n_active;
  };
  EXPECT_EQ(counts(1e-6), 2u);
  EXPECT_EQ(counts(1e-8), 1u) << "of the force of the other node";
  square.state.velocity = square.state.momentum = 2.;
  EXPECT_EQ(counts(1e-6), 1u) << "of the energy, some 30 over a size of about 1";
  EXPECT_EQ(counts(1e-5), 2u);
}

TEST(FrictionSummary, NothingWithoutFriction)
{
  SlidingSquare square;
  square.state.friction = FrictionState();
  const ContactSummary summary =
    contact_summary(square.problem.surface, square.problem.discretization, square.state);
  EXPECT_EQ(summary.n_active, 2u);
  EXPECT_EQ(summary.n_stick + summary.n_slip, 0u);
  EXPECT_EQ(summary.friction_force, 0.);
  EXPECT_EQ(summary.max_slip, 0.);
  const ProbeReading reading =
    Probe<2>({"corner", {1., 0.}}, square.problem.surface, MPI_COMM_WORLD).read(square.state);
  EXPECT_EQ(reading.tangential_force[0], 0.);
  EXPECT_EQ(reading.status, 0.);
}

TEST(FrictionProbe, ShowsForceAndSlip)
{
  const SlidingSquare square;
  const ProbeReading  reading =
    Probe<2>({"corner", {1., 0.}}, square.problem.surface, MPI_COMM_WORLD).read(square.state);
  EXPECT_DOUBLE_EQ(reading.normal_force, 1.);
  EXPECT_DOUBLE_EQ(reading.tangential_force[0], 0.4);
  EXPECT_EQ(reading.tangential_force[1], 0.);
  EXPECT_DOUBLE_EQ(reading.slip[0], -0.03);
  EXPECT_DOUBLE_EQ(reading.slip_path, 0.07);
  EXPECT_EQ(reading.status, contact_status::slip);
  EXPECT_EQ(Probe<2>({"middle", {0.5, 0.}}, square.problem.surface, MPI_COMM_WORLD)
              .read(square.state)
              .status,
            contact_status::stick);
}

// A slave that is pushed by s as a whole has relative entries of transmission times s, and a force
// that a node passes on counts as often.
TEST(FrictionSummary, TransmissionOfNodes)
{
  const TwoBodies<3> bodies(blocks_with_shares());
  const auto        &nodes = bodies.surface.nodes();
  State              state;
  auto              &friction = state.friction;
  state.displacement = state.contact_force = bodies.discretization.make_vector();
  friction.force = friction.slip = friction.accumulated_slip = state.contact_force;
  friction.slip_path.resize(nodes.size());
  friction.status.assign(nodes.size(), contact_status::slip);
  double force = 0., uneven = 0.;
  for (unsigned int k = 0; k < nodes.size(); ++k)
    {
      const double transmission                                = nodes[k].transmission;
      state.contact_force.local_element(3 * nodes[k].node + 1) = 0.5; // friction is part of it
      friction.force.local_element(3 * nodes[k].node + 1)      = 0.5;
      friction.slip.local_element(3 * nodes[k].node)           = transmission * 0.1;
      friction.accumulated_slip.local_element(3 * nodes[k].node + 1) = transmission * 0.2;
      friction.slip_path[k]                                          = transmission * 0.3;
      force += transmission * 0.5;
      uneven = std::max(uneven, std::abs(transmission - 1.));

      const FrictionReading<3> shown = friction_at(bodies.surface, friction, k);
      EXPECT_NEAR(shown.slip[0], 0.1, 1e-15);
      EXPECT_NEAR(shown.accumulated_slip[1], 0.2, 1e-15);
      EXPECT_NEAR(shown.slip_path, 0.3, 1e-15);
    }
  force  = dealii::Utilities::MPI::sum(force, MPI_COMM_WORLD);
  uneven = dealii::Utilities::MPI::max(uneven, MPI_COMM_WORLD);
  ASSERT_GT(uneven, 0.1);
  const ContactSummary summary = contact_summary(bodies.surface, bodies.discretization, state);
  EXPECT_NEAR(summary.friction_force, force, 1e-13);
  EXPECT_NEAR(summary.resultant[1], force, 1e-13);
  EXPECT_NEAR(summary.max_slip, 0.3, 1e-15);
}
