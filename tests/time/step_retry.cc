// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A step that cannot be solved is tried again from the same state with half the size, five times at
// most; with fixed steps the times of the whole steps are met again, so that a run that failed here
// and there ends where the others do. Each part is a step of its own whose works explain its change
// of energy exactly. What cannot be solved at all leaves the state as it was, and says when, how
// far down, and why. With step size control, a step that is taken back leaves no trace in the
// control.

#include <signorini/base/user_error.h>
#include <signorini/step_size/adaptive_steps.h>
#include <signorini/step_size/fixed_steps.h>
#include <signorini/step_size/force_estimate.h>
#include <signorini/step_size/step_doubling.h>

#include <gtest/gtest.h>

#include "bouncing_mass.h"
#include "elastic_bar.h"

using namespace signorini;

namespace
{
  /** Solves no step that is longer than a limit and touches a span of time. */
  class WeakScheme : public TimeScheme
  {
  public:
    explicit WeakScheme(const std::string &name)
      : scheme(make_time_scheme(name))
    {
    }

    double       limit = infinity, begin = 0., end = infinity;
    bool         blows_up = false; ///< instead of saying that it failed
    unsigned int n_calls = 0, n_failures = 0;

    Needs needs() const override { return scheme->needs(); }

    TakenStep make_step(DynamicalSystem &system, const State &start, const double tau) override
    {
      ++n_calls;
      const bool fails =
        tau > 1.001 * limit && start.time < end - 1e-9 && start.time + tau > begin + 1e-9;
      n_failures += fails;
      if (fails && !blows_up)
        throw StepError("the stub does not want to.");
      TakenStep step = scheme->make_step(system, start, tau);
      if (fails)
        step.state.velocity(0) = std::numeric_limits<double>::quiet_NaN();
      return step;
    }

  private:
    const std::unique_ptr<TimeScheme> scheme;
  };

  struct StepsMade
  {
    std::vector<double>       times, sizes;
    std::vector<unsigned int> rejected;
    double                    unexplained = 0.; ///< energy, at most in a step
    State                     end;
  };

  /** Ten steps of 0.1 of a mass on a spring that hits a wall at the time 0.45. */
  StepsMade ten_steps(TimeScheme &scheme)
  {
    BouncingMass system;
    system.spring = 1.;
    system.wall   = std::sin(0.45);
    StepsMade  run;
    FixedSteps steps(scheme, 0.1, 10);
    run.end = make_state(system, 0., 1.);
    while (!steps.finished(run.end))
      {
        const double     before = energy(system, run.end);
        const StepReport report = steps.advance(system, run.end);
        run.times.push_back(run.end.time);
        run.sizes.push_back(report.step_size);
        run.rejected.push_back(report.rejected_steps);
        const double explained = report.work_contact + report.work_predictor + report.work_friction
                                 + report.work_dirichlet + report.work_scheme;
        run.unexplained =
          std::max(run.unexplained, std::abs(energy(system, run.end) - before - explained));
      }
    return run;
  }

  void expect_near(const std::vector<double> &values, const std::vector<double> &expected)
  {
    ASSERT_EQ(values.size(), expected.size());
    for (unsigned int i = 0; i < values.size(); ++i)
      EXPECT_NEAR(values[i], expected[i], 1e-12) << i;
  }
} // namespace

TEST(FixedStepsTest, StepsThatCanBeSolvedStayAsTheyAre)
{
  WeakScheme      scheme("contact-stabilized");
  const StepsMade run = ten_steps(scheme);
  expect_near(run.sizes, std::vector<double>(10, 0.1));
  EXPECT_EQ(run.rejected, std::vector<unsigned int>(10, 0));
  EXPECT_EQ(scheme.n_calls, 10u);
}

TEST(FixedStepsTest, AStepThatFailsIsMadeInPartsAndTheGridIsMetAgain)
{
  for (const bool blows_up : {false, true})
    {
      WeakScheme scheme("contact-stabilized");
      scheme.limit        = 0.025;
      scheme.begin        = 0.41;
      scheme.end          = 0.48;
      scheme.blows_up     = blows_up;
      const StepsMade run = ten_steps(scheme);
      // The whole step, its half and a quarter; then the next quarter and the second half, which
      // fails again.
      expect_near(run.times, {0.1, 0.2, 0.3, 0.4, 0.425, 0.45, 0.475, 0.5, 0.6, 0.7, 0.8, 0.9, 1.});
      EXPECT_EQ(run.rejected, (std::vector<unsigned int>{0, 0, 0, 0, 2, 0, 1, 0, 0, 0, 0, 0, 0}));
      EXPECT_EQ(scheme.n_failures, 3u);
      EXPECT_EQ(run.end.step, 13u);
    }
}

TEST(FixedStepsTest, TheEnergyOfEveryPartIsExplained)
{
  for (const std::string &name : schemes_with_steps())
    {
      SCOPED_TRACE(name);
      if (make_time_scheme(name)->needs().massless_nodes)
        continue;
      WeakScheme scheme(name);
      scheme.limit        = 0.0125;
      scheme.begin        = 0.33;
      scheme.end          = 0.62;
      const StepsMade run = ten_steps(scheme);
      EXPECT_GT(scheme.n_failures, 3u);
      EXPECT_NEAR(run.end.time, 1., 1e-12);
      EXPECT_LT(run.unexplained, 1e-12);
    }
}

TEST(FixedStepsTest, AStepThatIsTakenBackIsMadeAgain)
{
  // The mesh may become finer in the middle of a step that is made in parts.
  WeakScheme scheme("contact-stabilized");
  scheme.limit = 0.05;
  BouncingMass system;
  FixedSteps   steps(scheme, 0.1, 10);
  State        state = make_state(system, 0., 1.);
  steps.advance(system, state);
  const State middle = state;
  EXPECT_NEAR(middle.time, 0.05, 1e-15);
  scheme.limit = infinity;
  for (unsigned int n = 0; n < 2; ++n)
    {
      state = middle;
      steps.advance(system, state);
      EXPECT_NEAR(state.time, 0.1, 1e-15);
      steps.take_back();
      steps.forget();
    }
  steps.advance(system, state);
  EXPECT_NEAR(state.time, 0.2, 1e-15);
}

TEST(FixedStepsTest, WhatCannotBeSolvedLeavesTheStateAndSaysWhy)
{
  WeakScheme scheme("contact-stabilized");
  scheme.limit = 1e-9;
  scheme.begin = 0.25;
  BouncingMass system;
  FixedSteps   steps(scheme, 0.1, 10);
  State        state = make_state(system, 0., 1.);
  steps.advance(system, state);
  steps.advance(system, state);
  std::string message;
  try
    {
      for (unsigned int n = 0; n < 20; ++n)
        steps.advance(system, state);
    }
  catch (const StepError &error)
    {
      message = error.what();
    }
  // In parts of 1/2 and, at the time 0.25, not even of 1/32.
  EXPECT_NEAR(state.time, 0.25, 1e-14);
  EXPECT_NEAR(state.displacement(0), 0.25, 1e-12);
  EXPECT_EQ(message,
            "no step from the time 0.25 was possible, down to the size 0.003125. the stub does not "
            "want to.");
}

TEST(AdaptiveStepsTest, AStepThatCannotBeSolvedIsRejectedAlsoBelowTheSmallestSize)
{
  WeakScheme scheme("contact-stabilized");
  scheme.limit = 0.002;
  scheme.begin = 0.4;
  scheme.end   = 0.5;
  BouncingMass  system;
  AdaptiveSteps steps(std::make_unique<ForceEstimate>(scheme, 0.01, 1), {0.1, 0.01, 0.01, 0.1, 1.});
  State         state    = make_state(system, 0., 1.);
  unsigned int  rejected = 0;
  double        smallest = 1.;
  while (!steps.finished(state))
    {
      const double     before = state.time;
      const StepReport report = steps.advance(system, state);
      rejected += report.rejected_steps;
      smallest = std::min(smallest, report.step_size);
      EXPECT_NEAR(state.time - before, report.step_size, 1e-12);
    }
  EXPECT_EQ(state.time, 1.);
  EXPECT_NEAR(state.displacement(0), 1., 1e-12);
  EXPECT_GT(scheme.n_failures, 0u);
  EXPECT_EQ(rejected, steps.rejected());
  EXPECT_GE(rejected, scheme.n_failures);
  EXPECT_NEAR(smallest, 0.01 / 8., 1e-9) << "the first that is below the limit";

  scheme.limit = 1e-9;
  scheme.begin = 0.;
  AdaptiveSteps hopeless(std::make_unique<ForceEstimate>(scheme, 0.01, 1),
                         {0.1, 0.01, 0.01, 0.1, 1.});
  state = make_state(system, 0., 1.);
  while (state.time < 0.3)
    {
      scheme.begin = 0.4;
      hopeless.advance(system, state);
    }
  scheme.begin = 0.;
  EXPECT_THROW(hopeless.advance(system, state), StepError);
}

TEST(AdaptiveStepsTest, AStepThatIsTakenBackLeavesNoTrace)
{
  // Two runs that differ by a step into the wall that is taken back: on a finer mesh the force may
  // be far smaller, and all further errors are relative to the largest one so far.
  const auto sizes = [](const bool with_a_mistake) {
    const auto scheme = make_time_scheme("contact-stabilized");
    ElasticBar bar(21);
    bar.distance      = {{100., 0.3}};
    const auto flying = [&](const double speed, const double place) {
      Vector displacement = bar.make_vector(), velocity = displacement;
      displacement = place;
      velocity     = speed;
      return make_state(bar, displacement, velocity);
    };
    AdaptiveSteps steps(std::make_unique<ForceEstimate>(*scheme, 0.02, 1),
                        {0.02, 0.02, 1e-3, 0.1, 2.});
    State         state = flying(1., 0.);
    steps.advance(bar, state);
    if (with_a_mistake)
      {
        State blow = flying(1000., 0.3);
        steps.advance(bar, blow);
        steps.take_back();
        steps.forget();
      }
    std::vector<double> result;
    while (!steps.finished(state))
      result.push_back(steps.advance(bar, state).step_size);
    return result;
  };
  const std::vector<double> clean = sizes(false), other = sizes(true);
  const double              smallest = *std::min_element(clean.begin(), clean.end());
  EXPECT_LT(smallest, 0.011) << "contact shall be too much for the first size";
  EXPECT_EQ(*std::min_element(other.begin(), other.end()), smallest);
  // What was too long once is too long again: only the steps until that is made up for differ.
  EXPECT_NEAR(other.size(), clean.size(), 4.);
}
