// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What the schemes beyond the paper's dissipative ones promise: the two of Laursen conserve energy
// to round-off through every impact; contact-stabilized with projected velocity loses energy by
// three non-positive terms and stops nodes that stay in contact; Moreau and Jean's loses energy;
// nonsmooth generalized-alpha stops what touches. A mass on a spring, a bar between two walls with
// loads, and the same driven in the middle.

#include <gtest/gtest.h>

#include "driven_scenes.h"

using namespace signorini;

// Of its own: all tests of a folder are compiled as one.
namespace conservation_tests
{
  namespace
  {
    constexpr double tau = 0.04, round_off = 1e-11;

    class Conservation : public testing::TestWithParam<const char *>
    {
    protected:
      std::pair<std::unique_ptr<DynamicalSystem>, State> scene  = make_scene(GetParam());
      DynamicalSystem                                   &system = *scene.first;
      State                                             &state  = scene.second;

      /** Change of energy in a step without the work of loads and of prescribed nodes. */
      double advance(TimeScheme &scheme, StepReport &report)
      {
        const State before = state;
        report             = scheme.advance(system, state, tau);
        Vector d           = state.displacement;
        d -= before.displacement;
        Vector load = system.make_vector();
        add_mean_load(system, load, 1., before.time, state.time);
        return energy(system, state) - energy(system, before) - load * d - report.work_dirichlet;
      }
    };
  } // namespace

  TEST_P(Conservation, LaursenAndChawlaConserveEnergyAndPenetrateALittle)
  {
    const auto scheme  = make_time_scheme("laursen-chawla");
    double     deepest = 0., largest_force = 0., fastest = 0.;
    for (unsigned int step = 0; step < 100; ++step)
      {
        StepReport report;
        ASSERT_NEAR(advance(*scheme, report), 0., round_off);
        ASSERT_NEAR(report.work_contact, 0., round_off);
        for (const double gap : system.normal_gap(state.displacement))
          deepest = std::max(deepest, -gap);
        fastest       = std::max(fastest, state.velocity.linfty_norm());
        largest_force = std::max(largest_force, state.contact_force.linfty_norm());
      }
    EXPECT_GT(largest_force, 0.1);
    EXPECT_GT(deepest, 1e-4);
    EXPECT_LT(deepest, tau * fastest);
  }

  // With a factor that the nodes have in common, and with impulses of their own.
  TEST_P(Conservation, LaursenAndLoveConserveEnergyWithoutPenetration)
  {
    const State start = state;
    for (const bool per_node : {false, true})
      {
        state = start;
        SchemeParameters parameters;
        parameters.impulses_per_node = per_node;
        const auto scheme            = make_time_scheme("laursen-love", parameters);
        double     largest_force     = 0.;
        for (unsigned int step = 0; step < 100; ++step)
          {
            StepReport   report;
            const double change = advance(*scheme, report);
            ASSERT_FALSE(report.common_impulses) << "step " << step;
            ASSERT_NEAR(change, 0., round_off) << "step " << step;
            ASSERT_NEAR(report.work_contact, 0., round_off) << "step " << step;
            for (const double gap : system.normal_gap(state.displacement))
              ASSERT_GE(gap, -round_off);
            for (const double force : system.relative_normal(state.contact_force))
              ASSERT_LE(force, round_off) << "adhesion";
            largest_force = std::max(largest_force, state.contact_force.linfty_norm());
          }
        EXPECT_GT(largest_force, 0.1);
      }
  }

  TEST_P(Conservation, ProjectedVelocityLosesEnergyAndStopsNodesInContact)
  {
    const auto   scheme = make_time_scheme("contact-stabilized-projected");
    double       lost   = 0.;
    unsigned int n_held = 0;
    for (unsigned int step = 0; step < 100; ++step)
      {
        const NormalGap before = system.normal_gap(state.displacement);
        StepReport      report;
        const double    change = advance(*scheme, report);
        ASSERT_NEAR(change, report.work_contact + report.work_predictor, round_off);
        ASSERT_LE(report.work_contact, round_off);
        ASSERT_LE(report.work_predictor, round_off);
        lost -= change;
        const NormalGap after    = system.normal_gap(state.displacement),
                        velocity = system.relative_normal(state.velocity);
        for (unsigned int k = 0; k < after.size(); ++k)
          {
            ASSERT_GE(after[k], -round_off);
            if (before[k] < round_off && after[k] < round_off)
              {
                ASSERT_NEAR(velocity[k], 0., round_off / tau);
                ++n_held;
              }
          }
        for (const double force : system.relative_normal(state.contact_force))
          ASSERT_LE(force, round_off / tau) << "adhesion";
      }
    EXPECT_GT(lost, 1e-3);
    EXPECT_GT(n_held, 0u);
  }

  // But for nodes that are pushed while they recede: they have penetrated before.
  TEST_P(Conservation, MoreauAndJeanLoseEnergyWhileBodiesApproach)
  {
    const auto scheme = make_time_scheme("moreau-jean");
    double     lost   = 0.;
    for (unsigned int step = 0; step < 100; ++step)
      {
        const NormalGap approach = system.relative_normal(state.velocity);
        StepReport      report;
        const double    change = advance(*scheme, report);
        ASSERT_NEAR(change, report.work_contact, round_off);
        const NormalGap force   = system.relative_normal(state.contact_force);
        bool            recedes = false;
        for (unsigned int k = 0; k < force.size(); ++k)
          recedes = recedes || (force[k] < 0. && approach[k] < 0.);
        if (!recedes)
          {
            ASSERT_LE(change, round_off);
          }
        lost -= change;
      }
    EXPECT_GT(lost, 1e-3);
  }

  TEST_P(Conservation, NonsmoothGeneralizedAlphaStopsNodesAndAccountsForEnergy)
  {
    const auto   scheme = make_time_scheme("nonsmooth-generalized-alpha");
    unsigned int n_held = 0;
    for (unsigned int step = 0; step < 100; ++step)
      {
        StepReport   report;
        const double change = advance(*scheme, report);
        ASSERT_NEAR(change, report.work_contact + report.work_scheme, round_off);
        const NormalGap force    = system.relative_normal(state.contact_force),
                        velocity = system.relative_normal(state.velocity);
        for (unsigned int k = 0; k < force.size(); ++k)
          {
            ASSERT_LE(force[k], round_off) << "adhesion";
            if (force[k] < 0.)
              {
                ASSERT_NEAR(velocity[k], 0., 1e-8);
                ++n_held;
              }
          }
      }
    EXPECT_GT(n_held, 0u);
  }

  TEST_P(Conservation, NonsmoothGeneralizedAlphaWithoutDampingIsMoreauAndJean)
  {
    const State      start = state;
    SchemeParameters parameters;
    parameters.spectral_radius = 1.;
    const auto one             = make_time_scheme("nonsmooth-generalized-alpha", parameters),
               other           = make_time_scheme("moreau-jean");
    for (unsigned int step = 0; step < 100; ++step)
      one->advance(system, state, tau);
    const Vector displacement = state.displacement;
    state                     = start;
    for (unsigned int step = 0; step < 100; ++step)
      other->advance(system, state, tau);
    for (unsigned int i = 0; i < displacement.size(); ++i)
      EXPECT_NEAR(displacement(i), state.displacement(i), 1e-9);
  }

  INSTANTIATE_TEST_SUITE_P(All,
                           Conservation,
                           testing::Values("mass_on_spring", "bar", "driven_bar"),
                           [](const auto &info) { return std::string(info.param); });
} // namespace conservation_tests
