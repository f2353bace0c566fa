// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The energy identity of a scheme is one of single steps: it holds to round-off when every step has
// another length, through impacts, with loads and moving boundaries.

#include <gtest/gtest.h>

#include "driven_scenes.h"

#include <random>

using namespace signorini;

namespace
{
  class VariableSteps : public testing::TestWithParam<std::tuple<std::string, std::string>>
  {
  };
} // namespace

TEST_P(VariableSteps, EnergyIdentity)
{
  const auto &[scheme_name, scene_name] = GetParam();
  auto scene                            = make_scene(scene_name);
  if (auto *bar = dynamic_cast<ElasticBar *>(scene.first.get());
      bar && (scheme_name == "khenous-laborde-renard" || scheme_name == "hager-hueeber-wohlmuth"))
    bar->remove_mass_of_ends();
  DynamicalSystem &system = *scene.first;
  State            state  = make_state(system, scene.second.displacement, scene.second.velocity);
  const auto       scheme = make_time_scheme(scheme_name);

  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> exponent(-2., 0.);
  unsigned int                           n_contact = 0;
  for (unsigned int step = 0; step < 200; ++step)
    {
      const double     tau    = 0.06 * std::pow(10., exponent(generator));
      const State      before = state;
      const StepReport report = scheme->advance(system, state, tau);
      Vector           d = state.displacement, load = system.make_vector();
      d -= before.displacement;
      add_mean_load(system, load, 1., before.time, state.time);
      const double explained = report.work_contact + report.work_predictor + report.work_dirichlet
                               + report.work_scheme + load * d;
      const double energy_before = energy(system, before), energy_now = energy(system, state);
      ASSERT_NEAR(
        energy_now - energy_before, explained, 1e-10 * std::max({1., energy_before, energy_now}))
        << "step " << step;
      n_contact += state.contact_force.linfty_norm() > 0.;
    }
  EXPECT_GE(n_contact, 2u) << "without impacts this test shows little";
}

INSTANTIATE_TEST_SUITE_P(All,
                         VariableSteps,
                         testing::Combine(testing::ValuesIn(schemes_with_steps()),
                                          testing::Values("mass_on_spring", "bar", "driven_bar")),
                         [](const auto &info) {
                           std::string name =
                             std::get<0>(info.param) + "_" + std::get<1>(info.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });
