// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What a run does, in which order: it observes the state of the start before the first step, writes
// a row for every accepted step in the order of time and nothing of rejected ones, and the fields
// of the end. When a step fails, what was there before stays and can be read, and the fields of the
// last state are written. A scene that cannot run does not touch the results of an earlier one.

#include "small_run.h"

#include <signorini/base/user_error.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  void expect_times(const std::vector<double> &times, const std::vector<double> &expected)
  {
    ASSERT_EQ(times.size(), expected.size());
    for (unsigned int i = 0; i < times.size(); ++i)
      EXPECT_NEAR(times[i], expected[i], 1e-9) << i;
  }

  /** A force that is not a number from this time on. */
  Override failure_after(const double time)
  {
    return {"Bodies/box/Body force", "0; 1/if(t > " + std::to_string(time) + ", 0, 1) - 1"};
  }
} // namespace

TEST(OrderOfSteps, TheStartIsTheFirstRow)
{
  SmallRun run;
  run.run();
  EXPECT_EQ(run.column("step")[0], 0.);
  EXPECT_EQ(run.column("time")[0], 0.);
  EXPECT_EQ(run.column("step_size")[0], 0.);
  EXPECT_NEAR(run.column("kinetic_energy")[0], 0.5 * 2. * 4., 1e-11);
  EXPECT_NEAR(run.column("momentum_y")[0], -4., 1e-11);
  EXPECT_EQ(run.column("elastic_energy")[0], 0.);
  EXPECT_EQ(run.column("contact_force")[0], 0.);
}

TEST(OrderOfSteps, ARowForEachStepInTheOrderOfTime)
{
  SmallRun run;
  run.run();
  const auto step = run.column("step"), time = run.column("time"), size = run.column("step_size"),
             force = run.column("contact_force"), momentum = run.column("momentum_y");
  ASSERT_EQ(step.size(), 11u);
  for (unsigned int n = 1; n <= 10; ++n)
    {
      EXPECT_EQ(step[n], n);
      EXPECT_NEAR(time[n], 0.01 * n, 1e-14);
      EXPECT_NEAR(size[n], 0.01, 1e-16);
      // State and force of a row belong to the same step.
      EXPECT_NEAR(momentum[n] - momentum[n - 1], size[n] * force[n], 1e-10) << n;
    }
  EXPECT_EQ(force[5], 0.) << "the approach";
  EXPECT_GT(force[6], 1.) << "the first step in contact";
}

TEST(OrderOfSteps, FieldsOfTheStartAndTheEnd)
{
  SmallRun run(std::vector<Override>{{"Output/VTU states", "1"}});
  run.run();
  expect_times(run.times_of_fields(), {0., 0.1});
  run.change({{"Output/VTU states", "4"}});
  run.run();
  // The first steps of 0.01 at or after a quarter of the time each.
  expect_times(run.times_of_fields(), {0., 0.03, 0.05, 0.08, 0.1});
  run.change({{"Output/VTU every", "4"}});
  run.run();
  expect_times(run.times_of_fields(), {0., 0.04, 0.08, 0.1});
  run.change({{"Output/VTU", "false"}});
  run.run();
  EXPECT_FALSE(run.has("volume.pvd")) << "of the earlier run";
}

// Bit for bit, but for the last column, which is the time that the run took; and what is not asked
// for leaves nothing.
TEST(OrderOfSteps, FieldsDoNotTouchTheHistory)
{
  const auto history = [](const SmallRun &run) {
    return std::regex_replace(run.text("history.csv"), std::regex(",[^,\n]*\n"), "\n");
  };
  SmallRun with(std::vector<Override>{{"Output/VTU every", "1"}});
  SmallRun without(std::vector<Override>{{"Output/VTU", "false"}});
  with.run();
  without.run();
  EXPECT_EQ(with.times_of_fields().size(), 11u);
  EXPECT_EQ(history(with), history(without));
  EXPECT_FALSE(without.has("fields"));
}

TEST(OrderOfSteps, RejectedStepsLeaveNoRow)
{
  SmallRun run({{"Time/Step size control", "force"},
                {"Time/Minimum step size", "2e-4"},
                {"Time/Step tolerance", "1e-2"}});
  run.run();
  const std::string log = run.text("log.txt");
  std::smatch       counts;
  ASSERT_TRUE(std::regex_search(log, counts, std::regex("(\\d+) accepted.* (\\d+) attempts rej")))
    << log;
  EXPECT_GT(std::stoi(counts[2]), 0) << "the impact shall be too much for the first step size";
  const auto step = run.column("step"), time = run.column("time"), size = run.column("step_size");
  ASSERT_EQ(step.size(), std::stoul(counts[1]) + 1);
  for (unsigned int n = 1; n < step.size(); ++n)
    {
      EXPECT_EQ(step[n], n);
      EXPECT_GT(size[n], 0.);
      EXPECT_NEAR(time[n] - time[n - 1], size[n], 1e-14) << n;
    }
  EXPECT_EQ(time.back(), 0.1);
}

TEST(OrderOfSteps, AFailureKeepsWhatWasComputed)
{
  SmallRun whole;
  whole.run();
  SmallRun run({failure_after(0.055), {"Output/VTU every", "2"}});
  EXPECT_THROW(run.run(), UserError);
  // Steps end at 0.05; the next one asks for loads after 0.055.
  const auto time = run.column("time");
  ASSERT_EQ(time.size(), 6u);
  EXPECT_NEAR(time.back(), 0.05, 1e-14);
  const auto energy = run.column("total_energy"), expected = whole.column("total_energy");
  for (unsigned int n = 0; n < time.size(); ++n)
    EXPECT_NEAR(energy[n], expected[n], 1e-12) << n;
  expect_times(run.times_of_fields(), {0., 0.02, 0.04, 0.05});
  EXPECT_NE(run.text("log.txt").find("ended early"), std::string::npos);
  EXPECT_EQ(whole.text("log.txt").find("ended early"), std::string::npos);
}

TEST(OrderOfSteps, AFailureOfTheFirstStepKeepsTheStart)
{
  SmallRun run({failure_after(0.001)});
  EXPECT_THROW(run.run(), UserError);
  EXPECT_EQ(run.column("time"), std::vector<double>{0.});
  expect_times(run.times_of_fields(), {0.});
}

TEST(OrderOfSteps, ASceneThatCannotRunTouchesNoResults)
{
  SmallRun run;
  run.run();
  const std::string history = run.text("history.csv"), log = run.text("log.txt");
  EXPECT_NE(run.validate().find("in order"), std::string::npos);
  run.change({{"Obstacles/floor/Point", "0, 0.2"}});
  EXPECT_THROW(run.validate(), UserError) << "the box is in the floor";
  EXPECT_THROW(run.run(), UserError);
  EXPECT_EQ(run.text("history.csv"), history);
  EXPECT_EQ(run.text("log.txt"), log);
}

namespace
{
  /** What is said against a value of a key; nothing if it is accepted. */
  std::string refusal_of(const std::string &key, const std::string &value)
  {
    SmallRun run(std::vector<Override>{{key, value}});
    try
      {
        run.validate();
      }
    catch (const UserError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

// The wave speed of the box is 18 with Poisson's ratio 0.3, its cells are 0.5: a step of 0.01 has
// the Courant number 0.37. Beyond 1e7 mass is lost in round-off of the stiffness.
TEST(OrderOfSteps, BodiesWithoutInertiaBesideTheirStiffnessAreRefused)
{
  const auto refusal = [](const char *modulus) {
    return refusal_of("Bodies/box/Young's modulus", modulus);
  };
  const std::string message = refusal("5e18");
  for (const char *word : {"Time/Step size = 0.01 gives the Courant number", "Use smaller steps"})
    EXPECT_NE(message.find(word), std::string::npos) << message;
  EXPECT_EQ(refusal("5e16"), "");
}

// A box that stands in equilibrium stays there. Contact that follows the motion asks for the forces
// of the state from which the equilibrium is found: there are none yet, and no vector without end.
TEST(OrderOfSteps, AnEquilibriumIsFoundWithoutForcesOfBefore)
{
  SmallRun run({{"Time/Start", "equilibrium"},
                {"Time/Scheme", "contact-stabilized-projected"},
                {"Contact/Motion", "follow"},
                {"Bodies/box/Initial velocity", "0; 0"},
                {"Bodies/box/Body force", "0; -1"},
                {"Obstacles/floor/Point", "0, 0"}});
  run.run();
  for (const double energy : run.column("kinetic_energy"))
    EXPECT_LT(energy, 1e-15);
  for (const double force : run.column("contact_force"))
    EXPECT_NEAR(force, 2., 1e-9); // its weight
}

// 1 is the size of the box: with steps of 0.01 it may be as fast as 1e10.
TEST(OrderOfSteps, BodiesWhosePositionsLoseAllDigitsAreRefused)
{
  const auto refusal = [](const char *velocity) {
    return refusal_of("Bodies/box/Initial velocity", velocity);
  };
  EXPECT_NE(refusal("1.8e19; -2").find("times the size of the bodies"), std::string::npos);
  EXPECT_EQ(refusal("1e6; -2"), "");
}
