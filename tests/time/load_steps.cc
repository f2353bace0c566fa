// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Load steps of a mass on a spring, whose equilibria are known: u = min(f/k, wall), and the wall
// bears the rest of the load. A path that comes back has taken no work from the wall, and what the
// books say of each step follows by hand.

#include <gtest/gtest.h>

#include "bouncing_mass.h"

using namespace signorini;

namespace load_step_tests
{
  constexpr double spring = 30., wall = 0.1;

  const std::string load_steps =
    schemes_where([](const SchemeInfo &info) { return !info.inertia; }).front();

  /** The mass under the loads 0, 1, ... of the times 0, 1, ... */
  struct LoadedMass
  {
    explicit LoadedMass(const std::vector<double> &loads)
    {
      system.spring = spring;
      system.wall   = wall;
      system.load   = [loads](const double t) { return loads[std::lround(t)]; };
    }

    BouncingMass                      system;
    State                             state  = make_state(system, 0., 0.);
    const std::unique_ptr<TimeScheme> scheme = make_time_scheme(load_steps);

    StepReport step() { return scheme->advance(system, state, 1.); }
  };

  TEST(LoadSteps, EachEndsInEquilibriumAtRest)
  {
    const std::vector<double> loads = {0., 1.5, 2.4, 5., 4., -6.};
    LoadedMass                mass(loads);
    for (std::size_t n = 1; n < loads.size(); ++n)
      {
        mass.step();
        EXPECT_NEAR(mass.state.displacement(0), std::min(loads[n] / spring, wall), 1e-15);
        EXPECT_NEAR(mass.state.contact_force(0), std::min(0., spring * wall - loads[n]), 1e-14);
        EXPECT_EQ(mass.state.velocity(0), 0.);
        EXPECT_EQ(mass.state.momentum(0), 0.);
      }
  }

  TEST(LoadSteps, TheWallTakesAndGivesTheSame)
  {
    LoadedMass       mass({0., 2., 5., 2., 0.});
    const double     before  = 2. / spring;
    const StepReport free    = mass.step();
    const StepReport closing = mass.step();
    const StepReport opening = mass.step();
    mass.step();
    EXPECT_EQ(free.work_contact, 0.);
    // The mean of no force and that of the end, over the way to the wall.
    EXPECT_NEAR(closing.work_contact, 0.5 * (spring * wall - 5.) * (wall - before), 1e-14);
    EXPECT_NEAR(opening.work_contact, -closing.work_contact, 1e-14);
    EXPECT_NEAR(energy(mass.system, mass.state), 0., 1e-15);
    for (const StepReport *report : {&free, &closing, &opening})
      EXPECT_NEAR(report->work_scheme, 0., 1e-14);
  }

  TEST(LoadSteps, AStartOutOfBalanceIsWorkOfTheScheme)
  {
    LoadedMass mass({2.4, 2.4});
    mass.state              = make_state(mass.system, 0., 3.);
    const StepReport report = mass.step();
    const double     u      = 2.4 / spring;
    // The load does 2.4 u, half of which is elastic then; the velocity is lost.
    EXPECT_NEAR(report.work_scheme, -0.5 * 2.4 * u - 0.5 * 9., 1e-14);
  }
} // namespace load_step_tests
