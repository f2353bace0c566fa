// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Damping of the bodies and of the scheme: each takes exactly the energy that its formula says, in
// every step with contact, and never adds any. Displacements that are much faster than a step
// shrink by the spectral radius, rigid motions are not damped. A predictor that was stopped in vain
// leaves no force across a gap.

#include <signorini/schemes/trapezoidal_rule.h>

#include <gtest/gtest.h>

#include "driven_scenes.h"

using namespace signorini;

namespace dissipation_tests
{
  namespace
  {
    constexpr double tau = 0.04, round_off = 1e-11;

    std::vector<std::string> damped_schemes()
    {
      return schemes_where([](const SchemeInfo &info) { return info.damping; });
    }

    SchemeParameters with_radius(const double rho)
    {
      SchemeParameters parameters;
      parameters.spectral_radius = rho;
      return parameters;
    }

    /** A bar that flies into a wall, without loads. */
    std::pair<std::unique_ptr<ElasticBar>, State> flying_bar(const SchemeInfo &info)
    {
      auto bar = std::make_unique<ElasticBar>(6);
      if (info.massless == MasslessNodesAre::needed)
        bar->remove_mass_of_ends();
      Vector u = bar->make_vector(), v = u;
      for (unsigned int i = 0; i < u.size(); ++i)
        v(i) = 1. + 0.5 * std::sin(i);
      for (const unsigned int i : bar->massless)
        v(i) = 1.;
      State state = make_state(*bar, u, v);
      return {std::move(bar), std::move(state)};
    }
  } // namespace

  TEST(Dissipation, IsBookedExactlyAndNeverNegative)
  {
    for (const std::string &name : damped_schemes())
      for (const double rho : {1., 0.9, 0.5, 0.})
        for (const bool viscous : {false, true})
          {
            const SchemeInfo &info = scheme_info(name);
            auto [bar, state]      = flying_bar(info);
            if (viscous)
              bar->damping = 0.3 * bar->mass + 0.02 * bar->stiffness;
            const auto scheme    = make_time_scheme(name, with_radius(rho));
            double     by_scheme = 0., by_damping = 0.;
            for (unsigned int step = 0; step < 60; ++step)
              {
                const State      before = state;
                const StepReport report = scheme->advance(*bar, state, tau);
                ASSERT_NEAR(energy(*bar, state) - energy(*bar, before),
                            report.work_contact + report.work_predictor + report.work_scheme
                              + report.work_damping,
                            round_off)
                  << name << ' ' << rho;
                ASSERT_LE(report.work_scheme, round_off) << name << ' ' << rho;
                ASSERT_LE(report.work_damping, 0.) << name << ' ' << rho;
                by_scheme += report.work_scheme;
                by_damping += report.work_damping;
              }
            const bool by_radius = rho < 1. && info.has_parameter("Spectral radius");
            EXPECT_EQ(by_scheme < -1e-3, by_radius || name == "backward-euler") << name << rho;
            EXPECT_EQ(by_damping < -1e-2, viscous) << name << ' ' << rho;
          }
  }

  TEST(Dissipation, FastDisplacementsShrinkByTheSpectralRadius)
  {
    // One element of a bar in free flight, its vibration 10 000 times faster than the step.
    for (const std::string &name : damped_schemes())
      if (scheme_info(name).has_parameter("Spectral radius")
          && scheme_info(name).massless != MasslessNodesAre::needed)
        for (const double rho : {0.9, 0.5})
          {
            ElasticBar bar(2);
            bar.distance = {{100., 100.}};
            Vector u = bar.make_vector(), v = u;
            u(0)                = -1.;
            u(1)                = 1.;
            State        state  = make_state(bar, u, v);
            const auto   scheme = make_time_scheme(name, with_radius(rho));
            const double omega = std::sqrt(12.), step = 1e4 / omega;
            for (unsigned int n = 0; n < 8; ++n)
              {
                const double before = state.displacement(1);
                scheme->advance(bar, state, step);
                EXPECT_NEAR(state.displacement(1), -rho * before, 1e-4 * std::abs(before))
                  << name << ' ' << n;
              }
          }
  }

  TEST(Dissipation, RigidMotionIsNotDamped)
  {
    // A bar falls freely from rest, however long the step and strong the damping of the scheme.
    for (const std::string &name : damped_schemes())
      if (scheme_info(name).has_parameter("Spectral radius")
          && scheme_info(name).massless != MasslessNodesAre::needed)
        {
          ElasticBar bar(6);
          bar.distance      = {{100., 100.}};
          bar.load          = [](double) { return 2.; };
          State      state  = make_state(bar, bar.make_vector(), bar.make_vector());
          const auto scheme = make_time_scheme(name, with_radius(0.3));
          for (unsigned int step = 0; step < 20; ++step)
            scheme->advance(bar, state, 0.1);
          // Total force 12, mass 1, time 2: the centre of gravity has moved by 24, with speed 24.
          const auto along = [&](const Vector &motion) {
            Vector ones = bar.make_vector(), product = ones;
            ones = 1.;
            bar.apply_mass(product, motion);
            return ones * product;
          };
          EXPECT_NEAR(along(state.displacement), 24., 1e-10) << name;
          EXPECT_NEAR(along(state.velocity), 24., 1e-10) << name;
        }
  }

  TEST(Dissipation, IsAutomaticOnlyWhereStepsAreLarge)
  {
    EXPECT_EQ(automatic_spectral_radius(0.1), 1.);
    EXPECT_EQ(automatic_spectral_radius(40.), 1.);
    EXPECT_NEAR(automatic_spectral_radius(40. * std::sqrt(2.)), 0.8, 1e-12);
    EXPECT_NEAR(automatic_spectral_radius(80.), 0.6, 1e-12);
    EXPECT_NEAR(automatic_spectral_radius(1e6), 0.6, 1e-12);
  }

  TEST(Dissipation, NoForceAcrossAGap)
  {
    // A bar is held in its middle. One end, 0.1 from the wall, alternates so fast that its free
    // increment reaches through the wall, while the step moves it by less than a hundredth of that.
    ElasticBar bar(6);
    bar.motion = [](double) { return 0.; };
    bar.stiffness *= 1e8;
    bar.distance = {{0.1, 0.1}};
    Vector u = bar.make_vector(), v = u;
    v(5)                          = 10.;
    State        state            = make_state(bar, u, v);
    const auto   scheme           = make_time_scheme("contact-stabilized-projected");
    unsigned int through_the_wall = 0;
    for (unsigned int step = 0; step < 20; ++step)
      {
        through_the_wall += tau * state.velocity(5) > 0.1;
        scheme->advance(bar, state, tau);
        const NormalGap gap = bar.normal_gap(state.displacement);
        EXPECT_NEAR(gap[1], 0.1, 1e-3);
        EXPECT_EQ(state.contact_force.linfty_norm(), 0.) << "step " << step;
      }
    EXPECT_GE(through_the_wall, 5u) << "else this test shows nothing";
  }
} // namespace dissipation_tests
