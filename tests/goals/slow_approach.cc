// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The energy that contact can still take from bodies that approach one another: for a body that
// goes straight at an obstacle its kinetic energy, for two bodies that of their relative motion
// with the reduced mass; nothing of a motion along the obstacle, whatever friction there is, of one
// that leads away, or of a fast one, and nothing where an obstacle moves or a body is held. A force
// is expected to rise with its root, and at most to twice as much.

#include "../contact/contact_scene.h"
#include "../contact/two_bodies.h"

#include <signorini/goals/force_error.h>
#include <signorini/goals/slow_approach.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  using Expressions = std::vector<std::array<std::string, 2>>; // by body

  /** Of rigid bodies with these velocities, all of whose contact nodes are pressed, and rubbed. */
  double energy(const ContactProblem<2> &problem, const Expressions &velocities)
  {
    const auto &discretization = problem.discretization;
    State       state;
    state.velocity      = discretization.interpolate(velocities);
    state.momentum      = discretization.make_vector();
    state.contact_force = discretization.make_vector();
    discretization.matrices().apply_mass(state.momentum, state.velocity);
    for (const ContactNode<2> &node : problem.surface.nodes())
      for (unsigned int c = 0; c < 2; ++c)
        state.contact_force.local_element(2 * node.node + c) =
          -3. * node.direction(0)[c] + 2. * node.direction(1)[c];
    const double force =
      dealii::Utilities::MPI::sum(3. * problem.surface.nodes().size(), MPI_COMM_WORLD);
    return energy_of_slow_approach(
      discretization, problem.surface, state, body_masses(problem.mesh), force);
  }
} // namespace

TEST(SlowApproach, OneBodyLosesWhatItHasAcross)
{
  const ContactProblem<2> problem(contact_scene<2>(box<2>(), {floor_at<2>(0.)}, {bottom_id<2>}));
  const double            mass = body_masses(problem.mesh).front();
  EXPECT_NEAR(mass, problem.mesh.bodies()[0].material.density, 1e-12);
  const auto of = [&](const std::string &along, const std::string &across) {
    return energy(problem, {{{along, across}}});
  };
  EXPECT_NEAR(of("0", "-0.001"), 0.5e-6 * mass, 1e-12 * mass);
  EXPECT_NEAR(of("0.3", "-0.001"), 0.5e-6 * mass, 1e-12 * mass) << "sliding brings no force";
  EXPECT_EQ(of("0", "0.001"), 0.) << "the body leaves";
  EXPECT_LT(of("0.1", "0"), 1e-20 * mass);
  const double wave_speed = problem.mesh.bodies()[0].material.pressure_wave_speed();
  EXPECT_GT(of("0", std::to_string(-wave_speed / 400.)), 0.);
  EXPECT_EQ(of("0", std::to_string(-wave_speed / 200.)), 0.) << "fast";
}

TEST(SlowApproach, NothingIsKnownOfWhatIsMoved)
{
  auto floor   = floor_at<2>(0.);
  floor.motion = std::make_shared<ObstacleMotion<2>>(
    "floor", ObstacleMotion<2>::Description{{{"0", "-t"}}, {{"", ""}}, "", {}, {}});
  const ContactProblem<2> moving(contact_scene<2>(box<2>(), {floor}, {bottom_id<2>}));
  EXPECT_EQ(energy(moving, {{{"0", "-0.001"}}}), 0.);

  BodyDescription<2> held = box<2>();
  held.dirichlet.push_back({top_id<2>, {{"0", ""}}});
  const ContactProblem<2> clamped(contact_scene<2>(held, {floor_at<2>(0.)}, {bottom_id<2>}));
  EXPECT_EQ(energy(clamped, {{{"0", "-0.001"}}}), 0.);
}

TEST(SlowApproach, TwoBodiesLoseTheirRelativeMotion)
{
  BodyDescription<2> low       = block<2>("low", {0., -2.}, {1., 0.}, {{2, 4}});
  low.material.density         = 3.;
  BodyDescription<2>      high = block<2>("high", {0., 0.}, {1., 1.}, {{2, 2}});
  const ContactProblem<2> problem(stacked(high, low));
  const auto              masses  = body_masses(problem.mesh);
  const double            reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
  EXPECT_NEAR(masses[0], 2., 1e-12);
  EXPECT_NEAR(masses[1], 6., 1e-12);
  // They go up together, and slide.
  const auto of = [&](const std::string &above, const std::string &below) {
    return energy(problem, {{{"0.2", above}}, {{"-0.1", below}}});
  };
  EXPECT_NEAR(of("0.009", "0.0105"), 0.5 * reduced * 0.0015 * 0.0015, 1e-12 * reduced);
  EXPECT_EQ(of("0.0105", "0.009"), 0.) << "they separate";
}

TEST(SlowApproach, ForceRisesWithTheRootOfTheEnergyUpToTwice)
{
  ForceReading reading;
  reading.force = 5.;
  EXPECT_EQ(reading.expected_force(), 5.) << "nothing is known";
  reading.elastic_energy = 4.;
  EXPECT_EQ(reading.expected_force(), 5.);
  reading.of_approach = 5.;
  EXPECT_NEAR(reading.expected_force(), 7.5, 1e-12);
  reading.of_approach = 1e6;
  EXPECT_EQ(reading.expected_force(), 10.);

  ForceError calm(0.01, 2), rising(0.01, 2);
  reading.squared_error = 1.;
  reading.time          = 0.1;
  rising.see(reading);
  reading.of_approach = 0.;
  calm.see(reading);
  EXPECT_NEAR(std::pow(rising.tolerance(), 2), 2. * std::pow(calm.tolerance(), 2), 1e-12)
    << "the error is tolerated in units of the expected force";
  EXPECT_TRUE(rising.is_high()) << "the largest force is one that was there";
}
