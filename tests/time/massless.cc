// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Schemes for contact nodes without mass, on a bar whose ends have lost theirs: the energy identity
// of Khenous, Laborde and Renard's Newmark schemes holds in every step, with loads and moving
// boundaries, in equilibrium at the end of each step; Hager, Hueeber and Wohlmuth's
// conserves the energy of its own mass; contact forces are continuous in time, as those of massive
// nodes are not.

#include <gtest/gtest.h>

#include "driven_scenes.h"

using namespace signorini;

// Of its own: all tests of a folder are compiled as one.
namespace massless_tests
{
  namespace
  {
    constexpr double tau = 0.02, round_off = 1e-11;

    struct Bar
    {
      std::unique_ptr<DynamicalSystem> system;
      State                            state;

      /** Thrown against a wall and back; with a load in time, or the node in the middle moved. */
      explicit Bar(const std::string &kind, const unsigned int n = 9)
      {
        auto bar = std::make_unique<ElasticBar>(n);
        bar->remove_mass_of_ends();
        if (kind == "loaded")
          bar->load = [](const double t) { return 0.3 * std::cos(2. * t); };
        if (kind == "driven")
          bar->motion = [](const double t) { return 0.4 * std::sin(4. * t); };
        Vector u = bar->make_vector(), v = u;
        for (unsigned int i = 0; i < v.size(); ++i)
          v(i) = 1. + 0.5 * std::sin(i);
        state  = make_state(*bar, u, v);
        system = std::move(bar);
      }

      double inertia() const // a.M~ a
      {
        Vector Ma = system->make_vector();
        system->apply_mass(Ma, state.acceleration);
        return state.acceleration * Ma;
      }
    };

    SchemeParameters newmark(const double beta, const double gamma)
    {
      SchemeParameters parameters;
      parameters.newmark_beta  = beta;
      parameters.newmark_gamma = gamma;
      return parameters;
    }

    const std::vector<std::pair<double, double>> choices = {{0.5, 0.5},
                                                            {0.25, 0.5},
                                                            {0.5, 1.},
                                                            {0.4, 0.6}};
  } // namespace

  TEST(Massless, EveryJouleIsBooked)
  {
    for (const auto &[beta, gamma] : choices)
      for (const std::string kind : {"free", "loaded", "driven"})
        {
          Bar        bar(kind);
          const auto scheme = make_time_scheme("khenous-laborde-renard", newmark(beta, gamma));
          double     largest_force = 0.;
          for (unsigned int step = 0; step < 150; ++step)
            {
              const State      before = bar.state;
              const StepReport report = scheme->advance(*bar.system, bar.state, tau);
              Vector           d = bar.state.displacement, load = bar.system->make_vector();
              d -= before.displacement;
              add_mean_load(*bar.system, load, 1., before.time, bar.state.time);
              ASSERT_NEAR(energy(*bar.system, bar.state) - energy(*bar.system, before) - load * d,
                          report.work_contact + report.work_dirichlet + report.work_scheme,
                          round_off)
                << kind << " " << beta << " step " << step;
              largest_force = std::max(largest_force, bar.state.contact_force.linfty_norm());
            }
          EXPECT_GT(largest_force, 0.1);
        }
  }

  TEST(Massless, TheMasterIdentityOfNewmark)
  {
    for (const auto &[beta, gamma] : choices)
      {
        Bar          bar("free");
        const auto   scheme  = make_time_scheme("khenous-laborde-renard", newmark(beta, gamma));
        const double Q       = 2. * beta - gamma;
        double       contact = 0.;
        scheme->advance(*bar.system, bar.state, tau);
        for (unsigned int step = 0; step < 150; ++step)
          {
            const State  before  = bar.state;
            const double inertia = bar.inertia();
            scheme->advance(*bar.system, bar.state, tau);
            Vector d = bar.state.displacement, jump = bar.state.acceleration, Ad = d, M_jump = d;
            d -= before.displacement;
            jump -= before.acceleration;
            bar.system->apply_stiffness(Ad, d);
            bar.system->apply_mass(M_jump, jump);
            const double work =
              (1. - gamma) * (before.contact_force * d) + gamma * (bar.state.contact_force * d);
            const double left = energy(*bar.system, bar.state) - energy(*bar.system, before)
                                + Q * tau * tau / 4. * (bar.inertia() - inertia);
            ASSERT_NEAR(left,
                        work - (gamma - 0.5) * (Ad * d + Q * tau * tau / 2. * (jump * M_jump)),
                        round_off)
              << beta << " " << gamma << " step " << step;
            contact += std::abs(work);
          }
        EXPECT_GT(contact, 1e-6) << "without impacts this test shows nothing";
      }
  }

  TEST(Massless, ContactConditionsAndEquilibriumAtTheEndOfEachStep)
  {
    for (const auto &[beta, gamma] : choices)
      {
        Bar        bar("loaded");
        const auto scheme = make_time_scheme("khenous-laborde-renard", newmark(beta, gamma));
        for (unsigned int step = 0; step < 150; ++step)
          {
            scheme->advance(*bar.system, bar.state, tau);
            const NormalGap gap   = bar.system->normal_gap(bar.state.displacement);
            const NormalGap force = bar.system->relative_normal(bar.state.contact_force);
            for (unsigned int k = 0; k < gap.size(); ++k)
              {
                ASSERT_GE(gap[k], -round_off);
                ASSERT_LE(force[k], round_off);
                ASSERT_NEAR(gap[k] * force[k], 0., round_off);
              }
            // M~ a + A u = f + r, in the massless rows, too
            Vector rest = bar.system->make_vector();
            bar.system->apply_mass(rest, bar.state.acceleration);
            rest += bar.state.internal_force;
            rest -= bar.state.contact_force;
            bar.system->add_load(rest, -1., bar.state.time);
            ASSERT_LT(rest.linfty_norm(), 1e-9);
            for (const unsigned int i : massless_entries(*bar.system))
              ASSERT_EQ(bar.state.acceleration(i), 0.);
          }
      }
  }

  TEST(Massless, HagerHueeberAndWohlmuthConserveTheEnergyOfTheirMass)
  {
    Bar          bar("free");
    const auto   scheme  = make_time_scheme("hager-hueeber-wohlmuth");
    const double initial = energy(*bar.system, bar.state);
    double       force = 0., deepest = 0.;
    for (unsigned int step = 0; step < 300; ++step)
      {
        scheme->advance(*bar.system, bar.state, tau);
        ASSERT_NEAR(energy(*bar.system, bar.state), initial, 1e-10 * initial);
        force = std::max(force, bar.state.contact_force.linfty_norm());
        for (const double gap : bar.system->normal_gap(bar.state.displacement))
          deepest = std::max(deepest, -gap);
      }
    EXPECT_GT(force, 0.1);
    EXPECT_GT(deepest, 1e-4);
  }

  TEST(Massless, ContactForcesAreContinuous)
  {
    // Halving the step halves the largest jump between steps (up to 0.75); with mass at the ends it
    // would grow.
    const auto largest_jump = [](const double step_size) {
      Bar        bar("free");
      const auto scheme = make_time_scheme("khenous-laborde-renard", newmark(0.25, 0.5));
      double     jump   = 0.;
      for (unsigned int step = 0; step < 2. / step_size; ++step)
        {
          const NormalGap before = bar.system->relative_normal(bar.state.contact_force);
          scheme->advance(*bar.system, bar.state, step_size);
          const NormalGap after = bar.system->relative_normal(bar.state.contact_force);
          for (unsigned int k = 0; k < after.size(); ++k)
            jump = std::max(jump, std::abs(after[k] - before[k]));
        }
      return jump;
    };
    const double coarse = largest_jump(0.01), fine = largest_jump(0.0025);
    EXPECT_GT(coarse, 0.01);
    EXPECT_LT(fine, 0.75 * 0.75 * coarse);
  }
} // namespace massless_tests
