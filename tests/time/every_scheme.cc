// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What every scheme has to do, on one bouncing mass and on a coarse bar between two walls: stop at
// the wall, or within the distance of one step behind it, press and never pull, balance momentum,
// explain every change of energy, and send the body back.

#include <gtest/gtest.h>

#include "bouncing_mass.h"
#include "elastic_bar.h"

using namespace signorini;

// Of its own: all tests of a folder are compiled as one.
namespace every_scheme_tests
{
  namespace
  {
    constexpr double tau = 0.02, round_off = 1e-10;

    /** Conditions on the velocity let a node go through the wall before they stop it. */
    bool may_penetrate(const std::string &scheme)
    {
      return scheme == "laursen-chawla" || scheme == "hager-hueeber-wohlmuth"
             || scheme == "moreau-jean" || scheme == "nonsmooth-generalized-alpha";
    }

    class EveryScheme : public testing::TestWithParam<std::string>
    {
    protected:
      const std::unique_ptr<TimeScheme> scheme = make_time_scheme(GetParam());

      /** Steps with contact; the projection of contact-stabilized is no contact force. */
      unsigned int n_touching = 0;

      /** A step, and what has to hold afterwards. */
      void advance(DynamicalSystem &system, State &state, const double speed)
      {
        const State      before = state;
        const StepReport report = scheme->advance(system, state, tau);
        Vector           d = state.displacement, load = system.make_vector();
        d -= before.displacement;
        add_mean_load(system, load, 1., before.time, state.time);
        ASSERT_NEAR(energy(system, state) - energy(system, before) - load * d,
                    report.work_contact + report.work_predictor + report.work_dirichlet
                      + report.work_scheme,
                    round_off);
        n_touching += report.corrector.n_active + report.predictor.n_active > 0
                      || state.contact_force.linfty_norm() > 0.;
        for (const double gap : system.normal_gap(state.displacement))
          ASSERT_GE(gap, may_penetrate(GetParam()) ? -tau * speed : -round_off);
        for (const double force : system.relative_normal(state.contact_force))
          ASSERT_LE(force, round_off);
      }
    };
  } // namespace

  TEST_P(EveryScheme, BouncesOneMassOnASpring)
  {
    BouncingMass system;
    system.mass   = 2.;
    system.spring = 30.;
    system.wall   = 0.1;
    State  state  = make_state(system, -0.2, 1.);
    double back   = 0.;
    for (unsigned int step = 0; step < 100; ++step)
      {
        advance(system, state, 2.5);
        back = std::min(back, state.displacement(0));
      }
    EXPECT_GT(n_touching, 0u);
    EXPECT_LT(back, 0.05) << "it never came back";
  }

  TEST_P(EveryScheme, ThrowsABarToAndFro)
  {
    ElasticBar system(9);
    if (scheme_info(GetParam()).massless == MasslessNodesAre::needed)
      system.remove_mass_of_ends();
    Vector v     = system.make_vector();
    v            = 1.;
    State  state = make_state(system, system.make_vector(), v);
    double right = 0., left = 0.; // impulses of both walls
    for (unsigned int step = 0; step < 200; ++step)
      {
        advance(system, state, 8.);
        const NormalGap force = system.relative_normal(state.contact_force);
        left -= tau * force[0];
        right -= tau * force[1];
      }
    EXPECT_GT(right, 0.5);
    EXPECT_GT(left, 0.5);
  }

  INSTANTIATE_TEST_SUITE_P(All,
                           EveryScheme,
                           testing::ValuesIn(schemes_of_motion()),
                           [](const auto &info) {
                             std::string name = info.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                           });
} // namespace every_scheme_tests
