// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What TimeScheme promises: a complete state after a step, an untouched one after an exception, and
// no memory.

#include <signorini/base/user_error.h>
#include <signorini/schemes/alpha_rule.h>

#include <gtest/gtest.h>

#include "bouncing_mass.h"
#include "elastic_bar.h"

using namespace signorini;

namespace
{
  const std::vector<std::string> schemes = schemes_with_steps();

  /** Fails in the call of a given number, whatever is called; its contact has friction. */
  class Failing : public BouncingMass
  {
  public:
    unsigned int calls = 0, fails_at = 0; ///< 0: never

    void apply_mass(Vector &destination, const Vector &source) const override
    {
      count();
      BouncingMass::apply_mass(destination, source);
    }

    void apply_stiffness(Vector &destination, const Vector &source) const override
    {
      count();
      BouncingMass::apply_stiffness(destination, source);
    }

    void add_load(Vector &destination, const double factor, const double time) override
    {
      count();
      BouncingMass::add_load(destination, factor, time);
    }

    Vector solve_mass(const Vector &force) override
    {
      count();
      return BouncingMass::solve_mass(force);
    }

    void solve(const IncrementProblem &problem, IncrementSolution &solution) override
    {
      count();
      EXPECT_GT(problem.force_factor, 0.) << "friction needs to know forces";
      BouncingMass::solve(problem, solution);
      add_friction(problem.force_factor, solution);
    }

    void equilibrate(const LoadStep &step, IncrementSolution &solution) override
    {
      count();
      BouncingMass::equilibrate(step, solution);
      add_friction(1., solution);
    }

    SolveReport project(const Vector    &free_increment,
                        const NormalGap &bounds,
                        double           step_size,
                        Vector          &correction,
                        Vector          &mass_correction) override
    {
      count();
      return BouncingMass::project(free_increment, bounds, step_size, correction, mass_correction);
    }

    SolveReport stop_relative_motion(const Vector    &velocity,
                                     const ActiveSet &held,
                                     Vector          &correction,
                                     Vector          &mass_correction) override
    {
      count();
      return BouncingMass::stop_relative_motion(velocity, held, correction, mass_correction);
    }

  private:
    void add_friction(const double force_factor, IncrementSolution &solution) const
    {
      solution.friction_reaction    = make_vector();
      solution.friction_reaction(0) = 0.1 * force_factor;
      solution.slip                 = solution.increment;
      solution.slip_length          = {std::abs(solution.increment(0))};
      solution.status               = {contact_status::stick};
    }

    void count() const
    {
      if (++const_cast<unsigned int &>(calls) == fails_at)
        throw RunError("no convergence");
    }
  };

  void expect_equal(const Vector &a, const Vector &b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (unsigned int i = 0; i < a.size(); ++i)
      EXPECT_EQ(a(i), b(i));
  }

  void expect_equal(const State &a, const State &b)
  {
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.time, b.time);
    expect_equal(a.displacement, b.displacement);
    expect_equal(a.velocity, b.velocity);
    expect_equal(a.contact_force, b.contact_force);
    expect_equal(a.momentum, b.momentum);
    expect_equal(a.internal_force, b.internal_force);
    expect_equal(a.acceleration, b.acceleration);
    expect_equal(a.friction.force, b.friction.force);
    expect_equal(a.friction.slip, b.friction.slip);
    expect_equal(a.friction.accumulated_slip, b.friction.accumulated_slip);
    EXPECT_EQ(a.friction.slip_path, b.friction.slip_path);
    EXPECT_EQ(a.friction.status, b.friction.status);
    EXPECT_EQ(a.last_step.size, b.last_step.size);
    expect_equal(a.last_step.velocity_change, b.last_step.velocity_change);
    expect_equal(a.last_step.momentum_change, b.last_step.momentum_change);
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

// Whatever call of the system fails: the state is the one before the step, friction and all.
TEST(Contract, AnExceptionLeavesTheStateAsItWas)
{
  for (const std::string &scheme : schemes)
    {
      Failing system;
      system.wall   = 0.1;
      system.spring = 2.;
      State state   = make_state(system, 0.1, 3.);
      make_time_scheme(scheme)->advance(system, state, 0.1); // with accelerations and friction now
      state.last_step    = {0.1, state.velocity, state.momentum};
      const State before = state;

      system.calls = 0;
      make_time_scheme(scheme)->advance(system, state, 0.1);
      const unsigned int n_calls = system.calls;
      ASSERT_GE(n_calls, 4u);
      for (system.fails_at = 1; system.fails_at <= n_calls; ++system.fails_at)
        {
          state        = before;
          system.calls = 0;
          EXPECT_THROW(make_time_scheme(scheme)->advance(system, state, 0.1), RunError) << scheme;
          expect_equal(state, before);
        }
    }
}

// A mass on a spring is all that most schemes ask for; the others are refused before they run.
TEST(Contract, SchemesSayWhatTheyNeed)
{
  for (const SchemeInfo &info : scheme_table())
    {
      MassOnSpring simple;
      BouncingMass system;
      const auto   scheme = info.make({});
      const bool   asks =
        info.predictor || info.impulses || !info.own_tolerance.empty() || !info.inertia;
      State state = make_state(simple, 0., 1.);
      if (asks)
        EXPECT_THROW(check_capabilities(*scheme, simple), UserError) << info.name;
      else
        {
          check_capabilities(*scheme, simple);
          scheme->advance(simple, state, 0.1);
          EXPECT_EQ(state.step, 1u);
        }
      if (info.own_tolerance.empty())
        EXPECT_NO_THROW(check_capabilities(*scheme, system)) << info.name;
      else
        EXPECT_THROW(check_capabilities(*scheme, system), UserError) << info.name;
    }
}

TEST(Contract, AStepDependsOnTheStateAlone)
{
  for (const std::string &name : schemes)
    {
      BouncingMass system;
      system.wall     = 0.1;
      system.spring   = 2.;
      const auto used = make_time_scheme(name);
      State other = make_state(system, 0.1, 3.), state = make_state(system, 0., 2.), again = state;
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

// The instants that the table gives for the contact forces are those of the rules.
TEST(Contract, TheTableKnowsTheInstantOfAForce)
{
  EXPECT_EQ(scheme_info("hht-alpha").force_before_end, "-p");
  EXPECT_EQ(scheme_info("generalized-alpha").force_before_end, "p/(1+p)");
  EXPECT_DOUBLE_EQ(AlphaRule::with_spectral_radius(0.6).alpha_f, 0.6 / (1. + 0.6));
}
