// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The size of steps follows the motion: undeformed flight takes growing steps that cost one
// solution each, contact begins with a small one, the end time is met exactly, a rejected step
// leaves no trace, and every run ends.

#include <signorini/step_size/adaptive_steps.h>
#include <signorini/step_size/force_estimate.h>
#include <signorini/step_size/goal_estimate.h>
#include <signorini/step_size/step_doubling.h>

#include <gtest/gtest.h>

#include "bouncing_mass.h"
#include "elastic_bar.h"

using namespace signorini;

namespace
{
  constexpr double minimum = 1e-3, first_size = 0.01, maximum = 0.5;

  struct Record
  {
    std::vector<State>       states; ///< after each accepted step
    std::vector<double>      sizes;
    unsigned int             solved = 0, rejected = 0;
    std::vector<std::string> news; ///< of all steps
    std::string              summary;
  };

  std::unique_ptr<GoalEstimate> make_goal(TimeScheme &scheme, const bool comes_back)
  {
    return std::make_unique<GoalEstimate>(
      scheme, first_size, ForceInStep{0.5, [] { return 0.; }}, comes_back);
  }

  template <typename Estimate>
  std::unique_ptr<StepEstimate> make_estimate(TimeScheme &scheme)
  {
    if constexpr (std::is_same_v<Estimate, ForceEstimate>)
      return std::make_unique<ForceEstimate>(scheme, first_size, 1);
    else if constexpr (std::is_same_v<Estimate, GoalEstimate>)
      return make_goal(scheme, false);
    else
      return std::make_unique<Estimate>(scheme);
  }

  template <typename Estimate>
  Record
  run(DynamicalSystem &system, const State &start, const double tolerance, const double end_time)
  {
    const auto    scheme = make_time_scheme("contact-stabilized");
    AdaptiveSteps steps(make_estimate<Estimate>(*scheme),
                        {tolerance, first_size, minimum, maximum, end_time});
    Record        record;
    State         state = start;
    while (!steps.finished(state))
      {
        record.sizes.push_back(steps.advance(system, state).step_size);
        record.states.push_back(state);
        for (const std::string &sentence : steps.news())
          record.news.push_back(sentence);
        if (record.sizes.size() > 20000)
          throw std::runtime_error("the run does not end");
      }
    record.solved   = steps.solved();
    record.rejected = steps.rejected();
    record.summary  = steps.summary();
    return record;
  }

  /** A bar of unit length and wave speed that flies towards the right wall. */
  ElasticBar make_bar(const double distance)
  {
    ElasticBar bar(21);
    bar.distance = {{100., distance}};
    return bar;
  }

  State flying(const DynamicalSystem &system, const double speed)
  {
    Vector velocity = system.make_vector();
    velocity        = speed;
    return make_state(system, system.make_vector(), velocity);
  }

  template <typename Estimate>
  class StepControl : public testing::Test
  {
  };
  using Estimates = testing::Types<StepDoubling, EmbeddedEstimate, ForceEstimate, GoalEstimate>;
  TYPED_TEST_SUITE(StepControl, Estimates);

  /** What holds for the estimates that follow the motion in flight, too. */
  template <typename Estimate>
  class MotionControl : public testing::Test
  {
  };
  using EstimatesOfMotion = testing::Types<StepDoubling, EmbeddedEstimate>;
  TYPED_TEST_SUITE(MotionControl, EstimatesOfMotion);

  /** What holds for those that measure steps by the contact force. */
  template <typename Estimate>
  class ForceControl : public testing::Test
  {
  };
  using EstimatesOfForce = testing::Types<ForceEstimate, GoalEstimate>;
  TYPED_TEST_SUITE(ForceControl, EstimatesOfForce);

  template <typename Estimate>
  constexpr double tolerated = std::is_same_v<Estimate, GoalEstimate> ? 0.02 : 0.1;
} // namespace

TYPED_TEST(StepControl, UndeformedFlightTakesGrowingStepsOfOneSolution)
{
  ElasticBar   system = make_bar(1e3);
  const Record record = run<TypeParam>(system, flying(system, 1.), 1e-6, 5.);
  EXPECT_EQ(record.rejected, 0u);
  // The first step has nothing to be compared with and is doubled: two solutions are thrown away at
  // most.
  EXPECT_LE(record.solved, record.sizes.size() + 2);
  EXPECT_LE(record.sizes.size(), 22u) << "twice 0.01, then 0.02 to 0.32, and 0.32 for the rest";
  for (std::size_t i = 3; i + 2 < record.sizes.size(); ++i)
    EXPECT_TRUE(record.sizes[i] > 1.9 * record.sizes[i - 1] || record.sizes[i] > 0.3) << i;
}

TYPED_TEST(StepControl, ConstantAccelerationIsFlight)
{
  BouncingMass system;
  system.load         = [](double) { return -1.; };
  const Record record = run<TypeParam>(system, make_state(system, 0., 0.), 1e-6, 5.);
  EXPECT_LE(record.solved, 30u);
  EXPECT_NEAR(record.states.back().displacement(0), -12.5, 1e-10);
}

TYPED_TEST(StepControl, TheEndIsMetExactly)
{
  for (const double end : {0.017, 0.5, 1. / 3., 1.999999})
    {
      ElasticBar   system = make_bar(0.3);
      const Record record = run<TypeParam>(system, flying(system, 1.), 0.1, end);
      EXPECT_EQ(record.states.back().time, end);
      EXPECT_GT(record.sizes.back(), 0.3 * minimum) << "a tiny last step";
      double sum = 0.;
      for (const double size : record.sizes)
        sum += size;
      EXPECT_NEAR(sum, end, 1e-13);
    }
}

// A tolerance that is only met with steps below the smallest size makes them all that small: the
// run says so once, soon, and counts them at the end. One that is met is not blamed.
TYPED_TEST(MotionControl, SaysThatAToleranceIsNotMet)
{
  ElasticBar   system = make_bar(0.5);
  const Record strict = run<TypeParam>(system, flying(system, 1.), 1e-7, 1.5);
  ASSERT_EQ(strict.news.size(), 1u);
  for (const char *part : {"0.00125", "tolerance = 1e-07", "larger tolerance"})
    EXPECT_NE(strict.news[0].find(part), std::string::npos) << strict.news[0];
  EXPECT_NEAR(std::stod(strict.news[0].substr(std::string("since time ").size())), 0.5, 0.01);
  EXPECT_NE(strict.summary.find("above the tolerance"), std::string::npos) << strict.summary;
  const Record usual = run<TypeParam>(system, flying(system, 1.), 0.3, 1.5);
  EXPECT_TRUE(usual.news.empty()) << usual.news[0];
}

TYPED_TEST(MotionControl, FirstTouchIsMetByASmallStep)
{
  ElasticBar   system = make_bar(2.);
  const Record record = run<TypeParam>(system, flying(system, 1.), 0.1, 6.);
  std::size_t  first  = 0;
  while (record.states[first].contact_force.linfty_norm() == 0.)
    ++first;
  EXPECT_LE(record.sizes[first], 2. * minimum);
  EXPECT_NEAR(record.states[first].time, 2., 3. * minimum);
  const auto largest = std::max_element(record.sizes.begin(), record.sizes.begin() + first);
  EXPECT_GT(*largest, 0.3) << "and the flight before by large ones";
  EXPECT_GT(*std::max_element(record.sizes.begin() + first, record.sizes.end()), 0.02)
    << "and those after grow again";
}

TYPED_TEST(StepControl, RoundOffAtTheTouchDecidesNothing)
{
  // Touches a whole number of steps away, or halves and quarters; velocities that differ by
  // round-off.
  for (const double distance : {1., 0.7, 0.64, 0.645, 0.6425, 0.3})
    {
      std::vector<Record> records;
      for (const double perturbation : {0., 1e-12, -1e-12, 1e-10, -1e-10})
        {
          ElasticBar system = make_bar(distance);
          records.push_back(run<TypeParam>(system, flying(system, 1. + perturbation), 0.1, 3.));
        }
      for (const Record &record : records)
        {
          ASSERT_EQ(record.sizes.size(), records[0].sizes.size()) << distance;
          EXPECT_EQ(record.rejected, records[0].rejected) << distance;
          for (std::size_t i = 0; i < record.sizes.size(); ++i)
            {
              ASSERT_NEAR(record.sizes[i], records[0].sizes[i], 1e-9) << distance << ' ' << i;
              const double force = record.states[i].contact_force.l1_norm();
              ASSERT_NEAR(force, records[0].states[i].contact_force.l1_norm(), 1e-5)
                << distance << ' ' << i;
            }
        }
    }
}

TYPED_TEST(StepControl, RejectedStepsLeaveNoTrace)
{
  ElasticBar   system = make_bar(0.7);
  const State  start  = flying(system, 1.);
  const Record record = run<TypeParam>(system, start, 0.02, 4.);
  ASSERT_GT(record.rejected, 0u) << "this test shows nothing";
  const auto scheme = make_time_scheme("contact-stabilized");
  State      state  = start;
  for (std::size_t i = 0; i < record.sizes.size(); ++i)
    {
      scheme->advance(system, state, record.sizes[i]);
      const State &recorded = record.states[i];
      ASSERT_EQ(state.step, recorded.step);
      ASSERT_NEAR(state.time, recorded.time, 1e-12);
      for (unsigned int k = 0; k < state.displacement.size(); ++k)
        {
          ASSERT_EQ(state.displacement(k), recorded.displacement(k));
          ASSERT_EQ(state.velocity(k), recorded.velocity(k));
          ASSERT_EQ(state.contact_force(k), recorded.contact_force(k));
        }
    }
}

TYPED_TEST(MotionControl, ASmallerToleranceMakesASmallerError)
{
  // A mass on a spring, compared with the cosine.
  std::vector<double> errors;
  for (const double tolerance : {1e-2, 1e-4})
    {
      BouncingMass system;
      system.spring       = 1.;
      const Record record = run<TypeParam>(system, make_state(system, 1., 0.), tolerance, 10.);
      errors.push_back(std::abs(record.states.back().displacement(0) - std::cos(10.)));
    }
  EXPECT_LT(errors[1], errors[0] / 10.);
  EXPECT_LT(errors[1], 1e-2);
}

TYPED_TEST(StepControl, EveryRunEnds)
{
  // No tolerance can be met where contact begins; at rest there is no error; the run may end in
  // contact.
  ElasticBar   tight  = make_bar(0.1);
  const Record record = run<TypeParam>(tight, flying(tight, 1.), 1e-8, 0.5);
  EXPECT_LE(record.sizes.size(), 1100u) << "halves of the smallest size everywhere";
  EXPECT_GT(record.states.back().contact_force.linfty_norm(), 0.);

  BouncingMass rest;
  EXPECT_LE((run<TypeParam>(rest, make_state(rest, 0., 0.), 1e-3, 5.).sizes.size()), 30u);

  // A target for the force remembers the blow at the start for a while.
  const unsigned int most = std::is_same_v<TypeParam, GoalEstimate> ? 200 : 60;
  BouncingMass       lying; // on the wall, and pressed by a load
  lying.wall = 0.;
  lying.load = [](double) { return 1.; };
  EXPECT_LE((run<TypeParam>(lying, make_state(lying, 0., 0.), 1e-3, 5.).sizes.size()), most);

  BouncingMass gliding = rest; // at the wall, approaching by round-off
  gliding.wall         = 0.;
  EXPECT_LE((run<TypeParam>(gliding, make_state(gliding, 0., 1e-17), 1e-3, 5.).sizes.size()), 30u);
}

TYPED_TEST(ForceControl, TouchIsFoundByItsForceAndVibratingFlightIsFree)
{
  ElasticBar   system  = make_bar(2.);
  const Record record  = run<TypeParam>(system, flying(system, 1.), tolerated<TypeParam>, 12.);
  const auto   pressed = [&](const std::size_t i) {
    return record.states[i].contact_force.linfty_norm() > 0.;
  };
  std::size_t begin = 0, end = record.sizes.size();
  while (!pressed(begin))
    ++begin;
  while (!pressed(end - 1))
    --end;
  EXPECT_LE(record.sizes[begin], 1.26 * first_size)
    << "a long step over the touch changes the force too much";
  EXPECT_NEAR(record.states[begin].time, 2., 2. * first_size);
  EXPECT_GT(*std::max_element(record.sizes.begin(), record.sizes.begin() + begin), 0.3);
  EXPECT_LE(*std::max_element(record.sizes.begin() + begin, record.sizes.begin() + end - 1),
            (std::is_same_v<TypeParam, GoalEstimate>) ? 0.05 : 0.1)
    << "the force is constant, but the wave that will end it is not";
  const State &released = record.states[end];
  EXPECT_GT(released.displacement * released.internal_force, 1e-3)
    << "no vibration: this test shows nothing";
  ASSERT_LT(end + 6, record.sizes.size());
  EXPECT_LE(std::count_if(record.sizes.begin() + end,
                          record.sizes.end(),
                          [](const double size) { return size < 0.3; }),
            10)
    << "some while the end swings back to the wall";
}

TYPED_TEST(ForceControl, UnitsOfForceDoNotMatter)
{
  std::vector<std::vector<double>> sizes;
  for (const double unit : {1., std::ldexp(1., 20)})
    {
      ElasticBar bar = make_bar(0.5);
      bar.mass *= unit;
      bar.stiffness *= unit;
      sizes.push_back(run<TypeParam>(bar, flying(bar, 1.), tolerated<TypeParam>, 3.).sizes);
    }
  EXPECT_EQ(sizes[0], sizes[1]);
}

TEST(StepEstimates, ForceThatMayComeBackFindsVibrationsInPhase)
{
  // A mass on a spring, far from any wall. Steps of the angle w estimate w^2 in units of the
  // amplitude, and are late by w^3/12: a twelfth of their estimate in each radian.
  const double tolerance = 1e-3;
  const auto   sizes     = [&](const bool comes_back) {
    BouncingMass system;
    system.spring              = 1.;
    const auto          scheme = make_time_scheme("contact-stabilized");
    AdaptiveSteps       steps(make_goal(*scheme, comes_back),
                        {tolerance, first_size, minimum, maximum, 20.});
    std::vector<double> result;
    for (State state = make_state(system, 1., 0.); !steps.finished(state);)
      result.push_back(steps.advance(system, state).step_size);
    return result;
  };
  const std::vector<double> free = sizes(false), followed = sizes(true);
  EXPECT_GT(*std::max_element(free.begin(), free.end()), maximum / 2.);
  const double largest = *std::max_element(followed.begin(), followed.end());
  EXPECT_LE(largest * largest / 12., 3. * tolerance) << "the latest are remembered where it turns";
  EXPECT_GE(largest * largest / 12., tolerance / 8.);
  EXPECT_LE(followed.size(), 16u + 20. / (largest / 2.)) << "few steps are shorter";
}

TEST(StepEstimates, Orders)
{
  // In free vibration the doubled step is compared to O(tau^3), the embedded prediction to
  // O(tau^2).
  BouncingMass system;
  system.spring     = 1.;
  const auto scheme = make_time_scheme("contact-stabilized");
  State      start  = make_state(system, 0.6, 0.8);
  const auto error  = [&](StepEstimate &estimate, const double tau) {
    State     before = start;
    StepTrial first;
    first.steps.push_back(take_step(*scheme, system, before, tau));
    record_changes(before, first);
    estimate.accept(before, first.steps.back().state);
    return estimate.attempt(system, first.steps.back().state, tau, 0.).error;
  };
  StepDoubling     doubling(*scheme);
  EmbeddedEstimate embedded(*scheme);
  EXPECT_NEAR(std::log2(error(doubling, 0.02) / error(doubling, 0.01)), 3., 0.1);
  EXPECT_NEAR(std::log2(error(embedded, 0.02) / error(embedded, 0.01)), 2., 0.1);
}
