// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Meshes that are made for the contact force. The estimate of its error follows from its
// definition, and so does what an indicator may amount to; a level of a body is due where an error
// is everywhere and not where it is in one place; only what is far from contact counts as waves;
// and a body matters while it touches something, or soon will. The same on any number of processes.

#include "box_of_cells.h"

#include <signorini/goals/base_levels.h>
#include <signorini/goals/bodies_in_touch.h>
#include <signorini/goals/force_error.h>
#include <signorini/goals/weigh_waves.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  ForceReading reading_at(const double time, const double force, const double square)
  {
    ForceReading reading;
    reading.time            = time;
    reading.force           = force;
    reading.elastic_energy  = 3.;
    reading.squared_error   = square;
    reading.of_uniform_mesh = std::exp2(2 * 4) * square;
    reading.n_cells         = 5. * std::exp2(2 * 4);
    reading.n_coarsest      = 5.;
    return reading;
  }

  State moving(const Discretization<2> &discretization, const double height, const double speed)
  {
    State state;
    state.displacement  = field<2>(discretization, {{"0", std::to_string(height)}});
    state.velocity      = field<2>(discretization, {{"0", std::to_string(speed)}});
    state.contact_force = discretization.make_vector();
    return state;
  }
} // namespace

TEST(ForceGoal, ToleranceIsTheTarget)
{
  ForceError error(0.01, 2);
  error.see(reading_at(0.1, 7., 1.));
  const double tolerated = std::pow(error.tolerance(), 2);
  for (const double time : {0.2, 0.3, 0.5})
    error.see(reading_at(time, 7., tolerated));
  ForceError only(0.01, 2);
  only.see(reading_at(0.1, 7., tolerated));
  EXPECT_NEAR(only.relative_error(), 0.01, 1e-14);
  // With half of the force the same tolerance leaves half of the error in the same force.
  only.see(reading_at(0.2, 3.5, tolerated));
  EXPECT_NEAR(std::pow(only.tolerance(), 2), 2. * tolerated, 1e-12 * tolerated);
}

// What the estimate cannot know is said: vibrations that are older than the contact, and contacts
// that come after others. Steps that are repeated count once.
TEST(ForceGoal, SaysWhatItDoesNotKnow)
{
  const std::string older = "vibrations before contact", alone = "contacts alone";
  const auto        says = [](const ForceError &error, const std::string &text) {
    return error.summary().find(text) != std::string::npos;
  };
  ForceError   error(0.01, 2), vibrating(0.01, 2);
  ForceReading touch          = reading_at(0.1, 2., 1.);
  touch.energy_before_contact = 0.1 * touch.elastic_energy;
  vibrating.see(touch);
  EXPECT_TRUE(says(vibrating, older));
  error.see(reading_at(0.1, 2., 1.));
  error.see(reading_at(0.1, 2., 1.));
  EXPECT_FALSE(says(error, older));
  error.see(reading_at(0.2, 0., 1.));
  EXPECT_FALSE(says(error, alone));
  touch.time = 0.3;
  error.see(touch); // in a flight between contacts bodies vibrate
  error.see(touch);
  EXPECT_FALSE(says(error, older));
  EXPECT_TRUE(says(error, "each of 2 contacts alone"));
}

TEST(ForceGoal, ErrorIsThatOfTheWholeTime)
{
  ForceError error(0.01, 3);
  error.see(reading_at(0.1, 2., 1.));
  const double once = error.relative_error();
  error.see(reading_at(0.1, 2., 4.)); // the step is repeated: the first attempt does not count
  EXPECT_NEAR(error.relative_error(), 4. * once, 1e-12 * once);
  error.see(reading_at(0.3, 2., 1.)); // weighs twice: it stands for twice the time
  EXPECT_NEAR(error.relative_error(), once * std::sqrt((16. + 2. * 1.) / 3.), 1e-12 * once);
  error.see(reading_at(0.9, 0., 5.)); // no contact, no error
  EXPECT_NEAR(error.relative_error(), once * std::sqrt(6.), 1e-12 * once);
}

TEST(ForceGoal, ForceThatRisesIsNotSettled)
{
  ForceError error(0.01, 2);
  EXPECT_FALSE(error.is_settled());
  error.see(reading_at(0.1, 2., 1.));
  EXPECT_FALSE(error.is_settled()); // the first contact
  error.see(reading_at(0.1, 3., 1.));
  EXPECT_FALSE(error.is_settled()); // the same step again
  error.see(reading_at(0.2, 4., 1.));
  EXPECT_TRUE(error.is_settled());
  error.see(reading_at(0.3, 9., 1.));
  EXPECT_FALSE(error.is_settled());
  error.see(reading_at(0.4, 1., 1.));
  EXPECT_TRUE(error.is_settled()); // falls
  error.see(reading_at(0.5, 0., 1.));
  EXPECT_FALSE(error.is_settled());
}

TEST(ForceGoal, UniformMeshIsItsOwnMatch)
{
  ForceError error(0.01, 2);
  EXPECT_NE(error.summary().find("no contact"), std::string::npos);
  error.see(reading_at(0.1, 2., 0.3));
  EXPECT_NEAR(error.uniform_level(), 4., 1e-12);
  EXPECT_NEAR(error.uniform_cells(), error.mean_cells(), 1e-9);
}

TEST(ForceGoal, ToleranceWithoutContactAndAtTheLimit)
{
  ForceError error(0.01, 2);
  error.see(reading_at(0.1, 0., 1.));
  EXPECT_GT(error.tolerance(), 1e100);
  error.see(reading_at(0.2, 2., 1.));
  const double tolerance = error.tolerance();
  EXPECT_EQ(error.least_part_of_tolerance(), 1.);
  error.see(reading_at(0.3, 0., 1.));
  EXPECT_EQ(error.tolerance(), tolerance);
  ForceReading limited = reading_at(0.4, 2., 100. * tolerance * tolerance);
  limited.at_limit     = 50. * tolerance * tolerance;
  error.see(limited);
  EXPECT_NEAR(error.tolerance(), 10. * tolerance, 1e-12 * tolerance);
}

TEST(ForceGoal, AContactThatLastsForgetsHowItBegan)
{
  // Tolerances go with the root of the elastic energy: a hundredth of it at first.
  const auto weak = [](const double time) {
    ForceReading reading   = reading_at(time, 2., 1.);
    reading.elastic_energy = 0.03;
    return reading;
  };
  ForceError error(0.01, 2);
  for (const double time : {1., 2.})
    error.see(weak(time));
  error.see(reading_at(3., 2., 1.));
  EXPECT_NEAR(error.least_part_of_tolerance(), 1. / 16., 1e-14); // not less than that
  error.see(reading_at(5., 2., 1.)); // a quarter of the time in contact is 1 to 2
  EXPECT_NEAR(error.least_part_of_tolerance(), 1. / 16., 1e-14);
  error.see(reading_at(5.1, 2., 1.));
  EXPECT_EQ(error.least_part_of_tolerance(), 1.);
  // Released and in contact again: it begins anew.
  error.see(reading_at(6., 0., 1.));
  for (const double time : {7., 7.5})
    error.see(weak(time));
  error.see(reading_at(8., 2., 1.));
  EXPECT_NEAR(error.least_part_of_tolerance(), 1. / 16., 1e-14);
}

TEST(ForceGoal, ArchiveGoesOn)
{
  ForceError error(0.01, 2), other(0.01, 2);
  error.see(reading_at(0.1, 2., 1.));
  std::stringstream stream;
  {
    Archive archive(static_cast<std::ostream &>(stream));
    error.archive(archive);
  }
  Archive archive(static_cast<std::istream &>(stream));
  other.archive(archive);
  for (ForceError *one : {&error, &other})
    one->see(reading_at(0.3, 1., 2.));
  EXPECT_EQ(error.relative_error(), other.relative_error());
  EXPECT_EQ(error.tolerance(), other.tolerance());
}

TEST(ForceGoal, LevelOfABodyIsDueWhereTheErrorIsEverywhere)
{
  const Box     box;
  BaseLevels<2> levels(box.mesh);
  const double  n_cells = box.mesh.triangulation().n_global_active_cells();
  const double  share   = 1. / n_cells;
  const auto    one     = box.indicator(
    [](const dealii::Point<2> &p) { return p[0] < 1. / 16. && p[1] < 1. / 16. ? 10. : 0.; });
  levels.see(one, 1., {true}); // one cell has a hundred times of what is tolerated
  EXPECT_EQ(levels[0], 0u);
  const auto all = box.indicator([&](const dealii::Point<2> &) { return std::sqrt(0.5 * share); });
  levels.see(all, 2., {true}); // they use up a quarter
  EXPECT_EQ(levels[0], 0u);
  levels.see(all, 1., {true}); // the half
  EXPECT_EQ(levels[0], 4u);
  levels.see(one, 1., {true}); // it stays
  EXPECT_EQ(levels[0], 4u);
  levels.see(all, 1., {false});
  EXPECT_EQ(levels[0], 0u);
}

TEST(ForceGoal, WavesAreFarFromContact)
{
  const Box         box;
  std::vector<bool> in_contact(box.mesh.triangulation().n_active_cells());
  const auto        equal     = box.indicator([](const dealii::Point<2> &) { return 1.; });
  auto              indicator = equal;
  EXPECT_EQ(weigh_waves(box.mesh, ContactZones<2>(box.mesh, in_contact), indicator), 0.);
  indicator -= equal;
  EXPECT_EQ(indicator.l2_norm(), 0.); // without contact nothing is far from it
  const double width = 1. / 8.;
  for (const auto &cell : box.mesh.active_cells())
    in_contact[cell->active_cell_index()] =
      cell->center()[0] < width && cell->center()[1] < 1. / 16.;
  indicator           = equal;
  const double n_near = weigh_waves(box.mesh, ContactZones<2>(box.mesh, in_contact), indicator);
  EXPECT_GT(n_near, 4.);
  EXPECT_LT(n_near, 100.);
  for (const auto &cell : box.mesh.active_cells())
    if (cell->is_locally_owned())
      {
        const double distance = cell->center().distance(dealii::Point<2>(0.5 * width, 0.));
        const double value    = indicator(cell->active_cell_index());
        const double expected = distance > 3. * width ? std::sqrt(2.) : 1.;
        if (distance < width || distance > 3. * width)
          {
            EXPECT_NEAR(value, expected, 1e-12);
          }
      }
}

TEST(ForceGoal, BodiesMatterWhileTheyTouch)
{
  const Box   box;
  const auto &discretization = box.problem.discretization;
  const auto &surface        = box.problem.surface;
  const auto  matters        = [&](const State &state) -> bool {
    return bodies_in_touch(discretization, surface, state)[0];
  };
  const double speed = box.mesh.bodies()[0].material.pressure_wave_speed();
  EXPECT_FALSE(matters(moving(discretization, 1., 0.)));
  EXPECT_FALSE(matters(moving(discretization, 1., -0.4 * speed))); // a wave is back before
  EXPECT_TRUE(matters(moving(discretization, 1., -0.6 * speed)));
  EXPECT_FALSE(matters(moving(discretization, 0.1, 0.6 * speed)));
  State pressed = moving(discretization, 1., 0.);
  for (const auto &node : surface.nodes())
    for (unsigned int c = 0; c < 2; ++c)
      pressed.contact_force.local_element(2 * node.node + c) = -node.normal()[c];
  EXPECT_TRUE(matters(pressed));
}
