// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The energy identity of each scheme holds to round-off in every step, with impacts, springs, loads
// and moving boundaries; contact dissipates where theory says so; nothing penetrates,
// nothing sticks, and a force needs contact.

#include <gtest/gtest.h>

#include "driven_scenes.h"

using namespace signorini;

// Of its own: all tests of a folder are compiled as one.
namespace energy_tests
{
  namespace
  {
    constexpr double tau = 0.04, round_off = 1e-11;

    class Energy : public testing::TestWithParam<std::tuple<std::string, std::string>>
    {
    protected:
      const std::string                                  scheme = std::get<0>(GetParam());
      std::pair<std::unique_ptr<DynamicalSystem>, State> scene =
        make_scene(std::get<1>(GetParam()));
      DynamicalSystem                  &system = *scene.first;
      State                            &state  = scene.second;
      const std::unique_ptr<TimeScheme> method = make_time_scheme(scheme);

      /** Normal components of a force. */
      NormalGap normal_components(const Vector &force) const
      {
        NormalGap       result = system.normal_gap(system.make_vector());
        const NormalGap moved  = system.normal_gap(force);
        for (unsigned int k = 0; k < result.size(); ++k)
          result[k] -= moved[k];
        return result;
      }

      double work_of_load(const State &before, const Vector &increment) const
      {
        Vector load = system.make_vector();
        add_mean_load(system, load, 1., before.time, before.time + tau);
        return load * increment;
      }

      /**
       * 2/tau^2 (tau v - p)'M(d - p) with the projected predictor p, without the reaction of
       * prescribed nodes, which is no loss.
       */
      double work_of_predictor(const State &before, const Vector &increment) const
      {
        Vector p = before.velocity, c, Mc;
        p *= tau;
        system.capabilities().projections->project(
          p, system.normal_gap(before.displacement), tau, c, Mc);
        p += c;
        Vector rest = increment;
        rest -= p;
        Mc -= dirichlet_part(system, Mc);
        return -2. / (tau * tau) * (Mc * rest);
      }
    };
  } // namespace

  TEST_P(Energy, IdentityInEveryStep)
  {
    double lost = 0.;
    for (unsigned int step = 0; step < 100; ++step)
      {
        const State      before = state;
        const StepReport report = method->advance(system, state, tau);
        Vector           d      = state.displacement;
        d -= before.displacement;
        const double change =
          energy(system, state) - energy(system, before) - work_of_load(before, d);
        double contact = state.contact_force * d, predictor = 0.;
        if (scheme == "newmark")
          contact = (contact + before.contact_force * d) / 2.;
        if (scheme == "contact-stabilized")
          predictor = work_of_predictor(before, d);
        ASSERT_NEAR(report.work_contact, contact, round_off);
        ASSERT_NEAR(report.work_predictor, predictor, round_off);
        ASSERT_NEAR(change,
                    report.work_contact + report.work_predictor + report.work_dirichlet
                      + report.work_scheme,
                    round_off);
        if (scheme != "newmark")
          {
            ASSERT_LE(contact, round_off);
            ASSERT_LE(predictor, round_off);
          }
        lost += std::abs(contact + predictor);
      }
    EXPECT_GT(lost, 1e-3) << "without impacts this test shows nothing";
  }

  TEST_P(Energy, ContactConditionsInEveryStep)
  {
    double largest_force = 0.;
    for (unsigned int step = 0; step < 100; ++step)
      {
        const StepReport report = method->advance(system, state, tau);
        const NormalGap  gap    = system.normal_gap(state.displacement);
        const NormalGap  force  = normal_components(state.contact_force);
        for (unsigned int k = 0; k < gap.size(); ++k)
          {
            ASSERT_GE(gap[k], -round_off) << "penetration";
            ASSERT_LE(force[k], round_off) << "adhesion";
            ASSERT_NEAR(gap[k] * force[k], 0., round_off) << "force at a distance";
            largest_force = std::max(largest_force, -force[k]);
          }
        ASSERT_TRUE(report.work_dirichlet == 0. || std::get<1>(GetParam()) == "driven_bar");
      }
    EXPECT_GT(largest_force, 0.1);
  }

  INSTANTIATE_TEST_SUITE_P(All,
                           Energy,
                           testing::Combine(testing::Values("newmark",
                                                            "contact-implicit",
                                                            "contact-stabilized",
                                                            "backward-euler"),
                                            testing::Values("mass_on_spring", "bar", "driven_bar")),
                           [](const auto &info) {
                             std::string name =
                               std::get<0>(info.param) + "_" + std::get<1>(info.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                           });
} // namespace energy_tests
