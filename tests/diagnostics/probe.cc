// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A probe watches the contact node that is closest to its point, and all processes get the reading
// of the owner: gap, motion along the normal out of the body, and pressure = force / weight,
// positive in compression. The summary of contact adds up the same forces.

#include "../contact/contact_scene.h"

#include <signorini/base/user_error.h>
#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/diagnostics/probe.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** A unit square with three contact nodes 0.2 above the floor. */
  Scene<2> square_above_floor()
  {
    return contact_scene<2>(box<2>(), {floor_at<2>(-0.2)}, {2});
  }

  /** Contact presses on the node (1/2, 0) with 3 and on (1, 0) with 1; (0, 0) is pulled with 0.5.
   */
  State pressed_state(const ContactProblem<2> &problem)
  {
    State state;
    state.displacement = field<2>(problem.discretization, {{"0", "-0.2 - 0.04*x"}});
    state.velocity     = field<2>(problem.discretization, {{"9", "-x"}});
    state.momentum = state.internal_force = state.contact_force =
      problem.discretization.make_vector();
    for (const ContactNode<2> &node : problem.surface.nodes())
      state.contact_force.local_element(2 * node.node + 1) = node.position[0] == 0.5  ? 3.
                                                             : node.position[0] == 1. ? 1.
                                                                                      : -0.5;
    return state;
  }
} // namespace

TEST(Probe, WatchesTheClosestContactNode)
{
  const ContactProblem<2> problem(square_above_floor());
  const Probe<2>          probe({"dent", {0.6, 0.9}}, problem.surface, MPI_COMM_WORLD);
  EXPECT_EQ(probe.name(), "dent");
  EXPECT_EQ(probe.position(), dealii::Point<2>(0.5, 0.));

  const ProbeReading reading = probe.read(pressed_state(problem));
  EXPECT_NEAR(reading.gap, -0.02, 1e-15);
  EXPECT_NEAR(reading.normal_displacement, 0.22, 1e-15);
  EXPECT_NEAR(reading.normal_velocity, 0.5, 1e-15);
  EXPECT_NEAR(reading.normal_force, 3., 1e-15);
  EXPECT_NEAR(reading.pressure, 6., 1e-14) << "half of the face belongs to the node";
}

TEST(Probe, NeedsAContactNode)
{
  const ContactProblem<2> problem(scene_of<2>({box<2>()}));
  EXPECT_THROW(Probe<2>({"lost", {0., 0.}}, problem.surface, MPI_COMM_WORLD), UserError);
}

TEST(ContactSummary, AddsUpTheNodes)
{
  const ContactProblem<2> problem(square_above_floor());
  const ContactSummary    summary =
    contact_summary(problem.surface, problem.discretization, pressed_state(problem));
  EXPECT_DOUBLE_EQ(summary.normal_force, 4.5);
  EXPECT_DOUBLE_EQ(summary.resultant[0], 0.);
  EXPECT_DOUBLE_EQ(summary.resultant[1], 3.5);
  EXPECT_EQ(summary.n_active, 3u);
  EXPECT_NEAR(summary.max_penetration, 0.04, 1e-15);
  EXPECT_DOUBLE_EQ(summary.max_tension, 0.5) << "the node that is pulled";
}
