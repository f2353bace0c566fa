// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// One mass meets the wall: what each scheme does to its velocity is known in closed form (Krause
// and Walloth 2012, section 3).

#include <gtest/gtest.h>

#include "bouncing_mass.h"
#include "elastic_bar.h"

using namespace signorini;

// Of its own: all tests of a folder are compiled as one.
namespace impact_tests
{
  namespace
  {
    constexpr double tau = 0.1, w = 3., mass = 2., round_off = 1e-12;

    /** A free mass in front of a wall. */
    BouncingMass free_mass(const double distance)
    {
      BouncingMass system;
      system.mass = mass;
      system.wall = distance;
      return system;
    }
  } // namespace

  TEST(Impact, ContactImplicitReboundDependsOnTheTimeOfTouch)
  {
    for (const double theta : {0., 0.25, 0.5, 0.75, 1.}) // fraction of the step before touch
      {
        BouncingMass system = free_mass(theta * tau * w);
        State        state  = make_state(system, 0., w);
        make_time_scheme("contact-implicit")->advance(system, state, tau);
        EXPECT_NEAR(state.displacement(0), system.wall, round_off);
        EXPECT_NEAR(state.velocity(0), -(1. - 2. * theta) * w, round_off);
        EXPECT_NEAR(state.contact_force(0), -2. * mass * w * (1. - theta) / tau, 1e-10);
      }
  }

  TEST(Impact, ContactImplicitVelocityAlternatesInContact)
  {
    BouncingMass system = free_mass(0.);
    system.load         = [](double) { return 200.; }; // strong enough to hold the mass
    State state         = make_state(system, 0., w);
    for (unsigned int step = 1; step <= 6; ++step)
      {
        make_time_scheme("contact-implicit")->advance(system, state, tau);
        EXPECT_NEAR(state.velocity(0), step % 2 ? -w : w, round_off);
        EXPECT_EQ(state.displacement(0), 0.);
      }
  }

  TEST(Impact, BackwardEulerStopsTheMassInTheStepAfterTouch)
  {
    const double theta  = 0.25;
    BouncingMass system = free_mass(theta * tau * w);
    State        state  = make_state(system, 0., w);
    const auto   scheme = make_time_scheme("backward-euler");
    scheme->advance(system, state, tau);
    EXPECT_NEAR(state.displacement(0), system.wall, round_off);
    EXPECT_NEAR(state.velocity(0), theta * w, round_off);
    EXPECT_NEAR(state.contact_force(0), -mass * w * (1. - theta) / tau, 1e-10);
    scheme->advance(system, state, tau);
    EXPECT_NEAR(state.velocity(0), 0., round_off);
  }

  TEST(Impact, NonsmoothGeneralizedAlphaStopsTheMassAndPenetrates)
  {
    for (const double theta : {0.4, 0.6}) // before and after the middle of the step
      {
        BouncingMass system = free_mass(theta * tau * w);
        State        state  = make_state(system, 0., w);
        make_time_scheme("nonsmooth-generalized-alpha")->advance(system, state, tau);
        const bool touches = theta < 0.5;
        EXPECT_NEAR(state.velocity(0), touches ? 0. : w, 1e-8 * w);
        EXPECT_NEAR(state.displacement(0), touches ? tau * w / 2. : tau * w, 1e-8 * w);
        EXPECT_NEAR(state.contact_force(0), touches ? -mass * w / tau : 0., 1e-7);
      }
  }

  TEST(Impact, NewmarkGainsEnergy)
  {
    for (const double theta : {0., 0.1, 0.3})
      {
        BouncingMass system = free_mass(theta * tau * w);
        State        state  = make_state(system, 0., w);
        const auto   scheme = make_time_scheme("newmark");
        scheme->advance(system, state, tau);
        EXPECT_NEAR(state.velocity(0), -(1. - 2. * theta) * w, round_off);
        EXPECT_NEAR(state.contact_force(0), -4. * mass * w * (1. - theta) / tau, 1e-10);
        // The other half of the force acts when the mass has gone: up to nine times the energy.
        scheme->advance(system, state, tau);
        EXPECT_NEAR(state.velocity(0), -(3. - 4. * theta) * w, round_off);
        EXPECT_EQ(state.contact_force(0), 0.);
      }
  }

  TEST(Impact, ContactStabilizedVelocityIsFrozenAndTheProjectionIsNoContactForce)
  {
    for (const double force : {0., 7.})
      {
        BouncingMass system = free_mass(0.25 * tau * w);
        system.load         = [force](double) { return force; };
        State      state    = make_state(system, 0., w);
        const auto scheme   = make_time_scheme("contact-stabilized");
        for (unsigned int step = 0; step < 5; ++step)
          {
            const StepReport report = scheme->advance(system, state, tau);
            EXPECT_NEAR(state.displacement(0), system.wall, round_off);
            EXPECT_NEAR(state.velocity(0), w, round_off);
            EXPECT_NEAR(state.contact_force(0), -force, 1e-10); // the static one
            EXPECT_EQ(report.predictor.n_active, 1u);
          }
      }
  }

  TEST(Impact, ContactStabilizedLosesEnergyAtRelease)
  {
    BouncingMass system     = free_mass(0.5);
    system.spring           = 40.;
    State            state  = make_state(system, 0.5, w); // in contact, pulled off by the spring
    const double     d      = -tau * tau / 2. * 40. * 0.5 / (mass + tau * tau / 4. * 40.);
    const StepReport report = make_time_scheme("contact-stabilized")->advance(system, state, tau);
    EXPECT_NEAR(state.displacement(0), 0.5 + d, round_off);
    EXPECT_NEAR(state.velocity(0), w + 2. / tau * d, round_off);
    EXPECT_NEAR(report.work_predictor, 2. / tau * mass * w * d, 1e-10);
    EXPECT_LT(report.work_predictor, -1.);
  }

  TEST(Impact, ContactStabilizedFreezesTheVelocityOfAContactNodeOfABar)
  {
    ElasticBar system(8);
    Vector     v           = system.make_vector();
    v                      = 1.;
    State        state     = make_state(system, system.make_vector(), v);
    const auto   scheme    = make_time_scheme("contact-stabilized");
    unsigned int n_contact = 0;
    for (unsigned int step = 0; step < 40; ++step)
      {
        const double before  = state.velocity(7);
        const auto   report  = scheme->advance(system, state, 0.05);
        const bool   contact = state.contact_force(7) < -1e-8;
        if (contact && report.predictor.n_active > 0)
          {
            ++n_contact;
            EXPECT_NEAR(state.velocity(7), before, 1e-11);
          }
      }
    EXPECT_GT(n_contact, 10u);
  }
} // namespace impact_tests
