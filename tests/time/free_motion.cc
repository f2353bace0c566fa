// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Without contact all schemes but the alpha methods and backward Euler are the trapezoidal rule: of
// second order, the same for all of them, with loads as the mean of their values at both ends of a
// step. The alpha methods are of second order, too; backward Euler is of first.

#include <gtest/gtest.h>

#include "bouncing_mass.h"

using namespace signorini;

namespace
{
  class FreeMotion : public testing::TestWithParam<const char *>
  {
  protected:
    const std::unique_ptr<TimeScheme> scheme = make_time_scheme(GetParam());

    /** Error of displacement and velocity of an oscillator with frequency 2 at time 3. */
    double error(const unsigned int n_steps) const
    {
      BouncingMass system;
      system.mass   = 0.5;
      system.spring = 2.;
      State state   = make_state(system, 1., 0.5);
      for (unsigned int step = 0; step < n_steps; ++step)
        scheme->advance(system, state, 3. / n_steps);
      const double u = std::cos(6.) + 0.25 * std::sin(6.),
                   v = -2. * std::sin(6.) + 0.5 * std::cos(6.);
      return std::hypot(state.displacement(0) - u, state.velocity(0) - v);
    }
  };
} // namespace

TEST_P(FreeMotion, OrderTwo)
{
  for (const unsigned int n_steps : {50, 100, 200})
    EXPECT_NEAR(std::log2(error(n_steps) / error(2 * n_steps)), 2., 0.01);
  EXPECT_LT(error(400), 1e-3);
}

TEST_P(FreeMotion, EnergyOfAnOscillatorIsConserved)
{
  BouncingMass system;
  system.spring       = 4.;
  system.wall         = 10.; // far away
  State        state  = make_state(system, 1., 0.5);
  const double before = energy(system, state);
  for (unsigned int step = 0; step < 100; ++step)
    {
      const StepReport report = scheme->advance(system, state, 0.3);
      EXPECT_EQ(report.corrector.n_active + report.predictor.n_active, 0u);
      EXPECT_EQ(report.work_contact, 0.);
      EXPECT_EQ(state.contact_force(0), 0.);
    }
  EXPECT_NEAR(energy(system, state), before, 1e-12);
}

TEST_P(FreeMotion, LoadsEnterAsTheMeanOfBothEnds)
{
  const double tau = 0.2, mass = 0.5, start = 0.7;
  const auto   f = [](const double t) { return 1. + t * t; };
  BouncingMass system;
  system.mass = mass;
  system.load = f;
  State state = make_state(system, 0.1, 2.);
  state.time  = start;
  scheme->advance(system, state, tau);
  const double acceleration = (f(start) + f(start + tau)) / (2. * mass);
  EXPECT_NEAR(state.velocity(0), 2. + tau * acceleration, 1e-13);
  EXPECT_NEAR(state.displacement(0), 0.1 + tau * 2. + tau * tau / 2. * acceleration, 1e-13);
}

class AlphaMethods : public FreeMotion
{
};

TEST_P(AlphaMethods, OrderTwo)
{
  for (const unsigned int n_steps : {100, 200})
    EXPECT_NEAR(std::log2(error(n_steps) / error(2 * n_steps)), 2., 0.05);
}

TEST_P(AlphaMethods, DampHighFrequencies)
{
  BouncingMass system;
  system.spring       = 1e4;
  State        state  = make_state(system, 1e-2, 0.5);
  const double before = energy(system, state);
  double       booked = 0.;
  for (unsigned int step = 0; step < 60; ++step)
    booked += scheme->advance(system, state, 0.3).work_scheme;
  EXPECT_LT(energy(system, state), 0.1 * before);
  EXPECT_NEAR(energy(system, state) - before, booked, 1e-9 * before)
    << "the report accounts for the damping";
}

INSTANTIATE_TEST_SUITE_P(All,
                         AlphaMethods,
                         testing::Values("hht-alpha",
                                         "generalized-alpha",
                                         "nonsmooth-generalized-alpha"),
                         [](const auto &info) { return std::string(info.param).substr(0, 3); });

class FirstOrder : public FreeMotion
{
};

TEST_P(FirstOrder, OrderOne)
{
  for (const unsigned int n_steps : {2000, 4000})
    EXPECT_NEAR(std::log2(error(n_steps) / error(2 * n_steps)), 1., 0.02);
}

INSTANTIATE_TEST_SUITE_P(All, FirstOrder, testing::Values("backward-euler"), [](const auto &) {
  return "backward_euler";
});

INSTANTIATE_TEST_SUITE_P(All,
                         FreeMotion,
                         testing::Values("newmark",
                                         "laursen-chawla",
                                         "laursen-love",
                                         "contact-implicit",
                                         "contact-stabilized",
                                         "contact-stabilized-projected",
                                         "moreau-jean"),
                         [](const auto &info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });
