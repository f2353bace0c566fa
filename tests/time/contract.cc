// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What TimeScheme promises: a complete state after a step, an untouched one after an exception, and no memory.

#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

#include "bouncing_mass.h"
#include "elastic_bar.h"

using namespace signorini;

namespace
{
  const std::vector<std::string> schemes = {"newmark",
                                            "laursen-chawla",
                                            "laursen-love",
                                            "contact-implicit",
                                            "contact-stabilized",
                                            "contact-stabilized-projected",
                                            "moreau-jean",
                                            "hht-alpha",
                                            "generalized-alpha",
                                            "khenous-laborde-renard",
                                            "hager-hueeber-wohlmuth",
                                            "nonsmooth-generalized-alpha",
                                            "backward-euler"};

  /** A mass whose solver fails. */
  class Failing : public BouncingMass
  {
  public:
    void solve(const IncrementProblem &problem, IncrementSolution &solution) override
    {
      BouncingMass::solve(problem, solution);
      throw RunError("no convergence");
    }
  };

  void expect_equal(const State &a, const State &b)
  {
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.time, b.time);
    const std::pair<const Vector &, const Vector &> vectors[] = {{a.displacement, b.displacement},
                                                                 {a.velocity, b.velocity},
                                                                 {a.contact_force, b.contact_force},
                                                                 {a.momentum, b.momentum},
                                                                 {a.internal_force, b.internal_force}};
    for (const auto &[x, y] : vectors)
      {
        ASSERT_EQ(x.size(), y.size());
        for (unsigned int i = 0; i < x.size(); ++i)
          EXPECT_EQ(x(i), y(i));
      }
  }
} // namespace

TEST(Contract, TheStateIsComplete)
{
  for (const std::string &scheme : schemes)
    {
      ElasticBar system(5);
      Vector     v = system.make_vector();
      v            = 1.;
      State state  = make_state(system, system.make_vector(), v);
      for (unsigned int step = 1; step <= 20; ++step)
        {
          make_time_scheme(scheme)->advance(system, state, 0.05);
          const State complete = make_state(system, state.displacement, state.velocity);
          EXPECT_EQ(state.step, step);
          EXPECT_NEAR(state.time, 0.05 * step, 1e-14);
          for (unsigned int i = 0; i < 5; ++i)
            {
              EXPECT_NEAR(state.momentum(i), complete.momentum(i), 1e-14);
              EXPECT_NEAR(state.internal_force(i), complete.internal_force(i), 1e-14);
            }
        }
    }
}

TEST(Contract, AnExceptionLeavesTheStateAsItWas)
{
  for (const std::string &scheme : schemes)
    {
      Failing system;
      system.wall         = 0.1;
      system.spring       = 2.;
      State state         = make_state(system, 0.1, 3.);
      state.step          = 4;
      state.time          = 0.7;
      state.contact_force = -1.;
      const State before  = state;
      EXPECT_THROW(make_time_scheme(scheme)->advance(system, state, 0.1), RunError);
      expect_equal(state, before);
    }
}

TEST(Contract, AStepDependsOnTheStateAlone)
{
  for (const std::string &name : schemes)
    {
      BouncingMass system;
      system.wall      = 0.1;
      system.spring    = 2.;
      const auto used  = make_time_scheme(name);
      State      other = make_state(system, 0.1, 3.), state = make_state(system, 0., 2.), again = state;
      used->advance(system, other, 0.2);
      used->advance(system, state, 0.1);
      make_time_scheme(name)->advance(system, again, 0.1);
      expect_equal(state, again);
    }
}

TEST(Contract, UnknownSchemesAreMistakesOfTheUser)
{
  EXPECT_THROW(make_time_scheme("leapfrog"), UserError);
}
