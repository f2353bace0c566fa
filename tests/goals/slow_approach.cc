// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The energy that contact can still take from bodies that approach one another: for a body that
// goes straight at an obstacle its kinetic energy, for two bodies that of their relative motion
// with the reduced mass; nothing of a motion along the obstacle, of one that leads away, or of a
// fast one. A force is expected to rise with its root, and at most to twice as much.

#include "box_of_cells.h"

#include <signorini/goals/force_error.h>
#include <signorini/goals/slow_approach.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  using Expressions = std::vector<std::array<std::string, 2>>; // by body

  /** Of rigid bodies with these velocities, pushed by these forces per mass. */
  double energy(const Discretization<2> &discretization,
                const Expressions       &velocities,
                const Expressions       &pushes)
  {
    State state;
    state.velocity      = discretization.interpolate(velocities);
    state.momentum      = discretization.make_vector();
    state.contact_force = discretization.make_vector();
    discretization.matrices().apply_mass(state.momentum, state.velocity);
    discretization.matrices().apply_mass(state.contact_force, discretization.interpolate(pushes));
    return energy_of_slow_approach(discretization, state, body_masses(discretization.mesh()));
  }
} // namespace

TEST(SlowApproach, OneBodyLosesWhatItHasAcross)
{
  const Box                box;
  const Discretization<2> &discretization = box.problem.discretization;
  const double             mass           = body_masses(box.mesh).front();
  const auto               of = [&](const std::string &along, const std::string &across) {
    return energy(discretization, {{{along, across}}}, {{{"0", "3"}}});
  };
  EXPECT_GT(mass, 0.);
  EXPECT_NEAR(of("0", "-0.001"), 0.5e-6 * mass, 1e-12 * mass);
  EXPECT_NEAR(of("0.3", "-0.001"), 0.5e-6 * mass, 1e-12 * mass) << "sliding brings no force";
  EXPECT_EQ(of("0", "0.001"), 0.) << "the body leaves";
  EXPECT_EQ(of("0.1", "0"), 0.);
  const double wave_speed = box.mesh.bodies()[0].material.pressure_wave_speed();
  EXPECT_GT(of("0", std::to_string(-wave_speed / 400.)), 0.);
  EXPECT_EQ(of("0", std::to_string(-wave_speed / 200.)), 0.) << "fast";
}

TEST(SlowApproach, TwoBodiesLoseTheirRelativeMotion)
{
  BodyDescription<2> light = box<2>(), heavy = box<2>();
  heavy.name             = "heavy";
  heavy.material.density = 3. * light.material.density;
  const Assembled<2> problem(scene_of<2>({light, heavy}));
  const auto         masses  = body_masses(problem.mesh);
  const double       reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
  EXPECT_NEAR(masses[1], 3. * masses[0], 1e-12);
  // Equal and opposite forces.
  const double found = energy(
    problem.discretization, {{{"0", "0.009"}}, {{"0", "0.0105"}}}, {{{"0", "3"}}, {{"0", "-1"}}});
  EXPECT_NEAR(found, 0.5 * reduced * 0.0015 * 0.0015, 1e-12 * reduced);
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
  EXPECT_EQ(rising.is_high(), true) << "the largest force is one that was there";
}
