// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Meshes that are made for a stress. The size of a stress is what its definition says of fields
// that are known; what a cell does to it falls with the distance by the power that second
// derivatives of influence functions have; and indicators add up to one exactly if the estimate is
// the target. The same on any number of processes.

#include "box_of_cells.h"

#include <signorini/goals/distance_to_places.h>
#include <signorini/goals/stress_error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** Whatever a test wants it to be: errors of all cells are equal. */
  class Given : public StressOfInterest<2>
  {
  public:
    double size = 1., sum_of_squares = 1., power = 1.5;

    std::string name() const override { return "given"; }
    Calibration calibration() const override { return {0.5, power}; }
    double      squared_size(const State &) const override { return size * size; }

    dealii::Vector<double> squared_errors(const State &,
                                          const ContactZones<2> &,
                                          const dealii::Vector<double> &squares) const override
    {
      dealii::Vector<double> result = squares;
      result *= sum_of_squares;
      return result;
    }
  };

  /** A box whose equal cells have squared indicators that add up to one. */
  struct Judged
  {
    Judged()
      : equal(box.indicator(
        [&](const auto &) { return 1. / box.mesh.triangulation().n_global_active_cells(); }))
      , in_contact(equal.size(), false)
    {
    }

    /** The sum of what is added to the relative squares of a step. */
    double see(StressError<2>    &error,
               const Given       &stress,
               const double       time,
               const unsigned int maximum_level = 9) const
    {
      State state;
      state.time = time;
      const StepRecord       step{state, state, 0.1};
      dealii::Vector<double> relative(equal.size());
      error.see(stress,
                box.mesh,
                step,
                ContactZones<2>(box.mesh, in_contact),
                equal,
                maximum_level,
                relative);
      double sum = 0.;
      for (const auto &cell : box.mesh.active_cells())
        if (cell->is_locally_owned())
          sum += relative(cell->active_cell_index());
      return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }

    Box                    box;
    dealii::Vector<double> equal;
    std::vector<bool>      in_contact;
  };

  State pressed(const Box &box, const double pressure)
  {
    State state;
    state.displacement  = box.problem.discretization.make_vector();
    state.velocity      = state.displacement;
    state.contact_force = state.displacement;
    for (const auto &node : box.problem.surface.nodes())
      for (unsigned int c = 0; c < 2; ++c)
        state.contact_force.local_element(2 * node.node + c) =
          -pressure * node.weight * node.normal()[c];
    return state;
  }

  /** Values in the columns in the middle, from the bottom up. */
  std::vector<double> column(const Box &box, const dealii::Vector<double> &values)
  {
    constexpr double    h = 1. / 16.;
    std::vector<double> result(16, 0.);
    for (const auto &cell : box.mesh.active_cells())
      if (cell->is_locally_owned() && std::abs(cell->center()[0] - 0.5 - 0.5 * h) < 0.1 * h)
        result[std::lround(cell->center()[1] / h - 0.5)] = values(cell->active_cell_index());
    dealii::Utilities::MPI::sum(result, MPI_COMM_WORLD, result);
    return result;
  }
} // namespace

TEST(StressGoal, SizeOfPressureIsItsSquareOverTheSurface)
{
  const Box  box;
  const auto stress = make_contact_pressure(box.problem.discretization, box.problem.surface);
  EXPECT_EQ(stress->squared_size(State()), 0.);
  EXPECT_NEAR(stress->squared_size(pressed(box, 3.)), 9. * box.problem.area(), 1e-11);
}

TEST(StressGoal, PressureOfOnePairIsItsPart)
{
  // A box between a floor and a ceiling, which presses three times as much.
  const Box               floor_only;
  const ContactProblem<2> problem(contact_scene<2>(
    Box::finer(box<2>()),
    {floor_at<2>(0.),
     plane<2>("ceiling", dealii::Point<2>(0., 1.), dealii::Tensor<1, 2>({0., -1.}))}));
  const auto             &surface = problem.surface;
  State                   state;
  state.displacement  = problem.discretization.make_vector();
  state.velocity      = state.displacement;
  state.contact_force = state.displacement;
  for (const auto &node : surface.nodes())
    for (unsigned int c = 0; c < 2; ++c)
      state.contact_force.local_element(2 * node.node + c) =
        -(node.pair == 0 ? 1. : 3.) * node.weight * node.normal()[c];
  const auto size = [&](const std::optional<unsigned int> pair) {
    return make_contact_pressure(problem.discretization, surface, pair)->squared_size(state);
  };
  EXPECT_NEAR(size({}), size(0) + size(1), 1e-12 * size({}));
  EXPECT_GT(size(1), 2. * size(0));
  EXPECT_GT(size(0), 0.);
  // A probe at the floor has the mean error of the floor's contact.
  const auto              one = floor_only.indicator([](const auto &) { return 1.; });
  const std::vector<bool> in_contact(one.size(), true);
  const ContactZones<2>   zones(problem.discretization.mesh(), in_contact);
  const auto              probed = make_probed_stress(
    ProbeDescription<2>{"p", dealii::Point<2>(0.5, 0.)}, problem.discretization, surface);
  double area = 0.;
  for (const auto &node : surface.nodes())
    if (node.pair == 0)
      area += node.weight;
  area = dealii::Utilities::MPI::sum(area, MPI_COMM_WORLD);
  auto difference =
    make_contact_pressure(problem.discretization, surface, 0u)->squared_errors(state, zones, one);
  difference.add(-area, probed->squared_errors(state, zones, one));
  EXPECT_LT(difference.linfty_norm(), 1e-9);
}

TEST(StressGoal, StressAtProbes)
{
  const Box   box;
  const auto &discretization = box.problem.discretization;
  const auto  pressure       = make_probed_stress(
    ProbeDescription<2>{"p", dealii::Point<2>(0.5, 0.)}, discretization, box.problem.surface);
  EXPECT_EQ(pressure->squared_size(State()), 0.);
  EXPECT_NEAR(pressure->squared_size(pressed(box, 3.)), 9., 1e-12);
  // All of the surface has this pressure: the mean of the errors over its area.
  const auto              all = make_contact_pressure(discretization, box.problem.surface);
  const auto              one = box.indicator([](const auto &) { return 1.; });
  const std::vector<bool> in_contact(one.size(), true);
  auto difference = all->squared_errors(State(), ContactZones<2>(box.mesh, in_contact), one);
  difference.add(
    -box.problem.area(),
    pressure->squared_errors(pressed(box, 3.), ContactZones<2>(box.mesh, in_contact), one));
  EXPECT_LT(difference.linfty_norm(), 1e-9);

  // Shear alone: sigma:sigma = 2 (mu gamma)^2.
  State state;
  state.displacement = field<2>(discretization, {{"1e-3*y", "0"}});
  state.velocity     = discretization.make_vector();
  const auto inside  = make_probed_stress(
    PointProbeDescription<2>{"q", "box", 0, dealii::Point<2>(0.4, 0.3)}, discretization);
  const double mu = box.mesh.bodies()[0].material.mu();
  EXPECT_NEAR(inside->squared_size(state), 2. * std::pow(1e-3 * mu, 2), 1e-12 * mu * mu);
}

TEST(StressGoal, InfluenceOnPressureFallsWithTheDistance)
{
  const Box         box;
  constexpr double  h = 1. / 16.;
  std::vector<bool> in_contact(box.mesh.triangulation().n_active_cells());
  for (const auto &cell : box.mesh.active_cells())
    in_contact[cell->active_cell_index()] = cell->center()[1] < h;
  const auto   stress = make_contact_pressure(box.problem.discretization, box.problem.surface);
  const double mu     = box.mesh.bodies()[0].material.mu();
  const auto   equal  = box.indicator([](const auto &) { return 1.; });
  const auto   rows =
    column(box, stress->squared_errors(State(), ContactZones<2>(box.mesh, in_contact), equal));
  EXPECT_NEAR(rows[0], mu / h, 1e-9 * mu);
  for (const double k : {1., 2., 3., 5.}) // the zone of contact is larger than these distances
    EXPECT_NEAR(rows[k], mu / h * std::pow(k, -5.), 1e-9 * mu);
  // Without contact there is no pressure to be wrong.
  in_contact.assign(in_contact.size(), false);
  EXPECT_EQ(stress->squared_errors(State(), ContactZones<2>(box.mesh, in_contact), equal).l2_norm(),
            0.);
}

TEST(StressGoal, InfluenceOnAPointFallsWithTheDistance)
{
  const Box        box;
  constexpr double h      = 1. / 16.;
  const auto       stress = make_probed_stress(
    PointProbeDescription<2>{"q", "box", 0, dealii::Point<2>(0.5 + 0.5 * h, 0.5 * h)},
    box.problem.discretization);
  const double      mu    = box.mesh.bodies()[0].material.mu();
  const auto        equal = box.indicator([](const auto &) { return 1.; });
  std::vector<bool> in_contact(equal.size(), true);
  const auto        at_rest =
    column(box, stress->squared_errors(State(), ContactZones<2>(box.mesh, in_contact), equal));
  EXPECT_NEAR(at_rest[0], mu / (h * h), 1e-9 * mu);
  for (const double k : {1., 2., 7., 15.})
    EXPECT_NEAR(at_rest[k], mu / (h * h) * std::pow(k, -6.), 1e-9 * mu);
  // Far from contact there are waves: the mean error of the stress of a body with unit volume,
  // whose squared error in the energy norm is 1/15, and with it sigma:sigma is 2 mu/15.
  in_contact.assign(in_contact.size(), false);
  const auto with_waves =
    column(box, stress->squared_errors(State(), ContactZones<2>(box.mesh, in_contact), equal));
  for (const unsigned int k : {0, 7, 15})
    EXPECT_NEAR(std::pow(stress->calibration().factor, 2) * (with_waves[k] - at_rest[k]),
                2. * mu / 15.,
                1e-9 * mu);
}

TEST(StressGoal, WhatIsUsualInABody)
{
  const Box   box;
  const auto &discretization = box.problem.discretization;
  const auto  stress         = make_probed_stress(
    PointProbeDescription<2>{"q", "box", 0, dealii::Point<2>(0.4, 0.3)}, discretization);
  State state;
  state.displacement   = field<2>(discretization, {{"1e-3*y", "0"}});
  state.velocity       = discretization.make_vector();
  state.internal_force = stiffness_times(discretization, state.displacement);
  // The same everywhere: what is usual is what there is.
  EXPECT_NEAR(stress->usual_squared_size(state) / stress->squared_size(state), 1., 1e-10);
  EXPECT_TRUE(stress->lasts_in(0));
}

TEST(StressGoal, DistanceIsThatOfTheNearestPlaceOfTheBody)
{
  const Box              box;
  std::vector<bool>      marked(box.mesh.triangulation().n_active_cells());
  const dealii::Point<2> one(0.5 / 16., 0.5 / 16.), other(15.5 / 16., 0.5 / 16.);
  for (const auto &cell : box.mesh.active_cells())
    marked[cell->active_cell_index()] =
      cell->is_locally_owned()
      && std::min(cell->center().distance(one), cell->center().distance(other)) < 1e-6;
  const DistanceToPlaces<2> distance(box.mesh, marked);
  for (const auto &cell : box.mesh.active_cells())
    if (cell->is_locally_owned())
      {
        EXPECT_NEAR(distance(cell),
                    std::min(cell->center().distance(one), cell->center().distance(other)),
                    1e-12);
      }
  const DistanceToPlaces<2> nowhere(box.mesh, std::vector<bool>(marked.size(), false));
  for (const auto &cell : box.mesh.active_cells())
    if (cell->is_locally_owned())
      {
        EXPECT_EQ(nowhere(cell), std::numeric_limits<double>::infinity());
      }
}

TEST(StressGoal, IndicatorsAddUpToOneAtTheTarget)
{
  const Judged judged;
  for (const double power : {1., 1.5})
    {
      StressError<2> error(0.02);
      Given          stress;
      stress.power          = power;
      stress.size           = 7.;
      stress.sum_of_squares = std::pow(7. * std::pow(0.02 / 0.5, 1. / power), 2);
      EXPECT_NEAR(judged.see(error, stress, 0.1), 1., 1e-10);
      EXPECT_NEAR(error.relative_error(), 0.02, 1e-12);
      // A smaller stress later: its error counts in units of the largest one.
      stress.size           = 3.5;
      stress.sum_of_squares = std::pow(3.5 * std::pow(0.04 / 0.5, 1. / power), 2);
      EXPECT_NEAR(judged.see(error, stress, 0.2), 1., 1e-10);
      EXPECT_NEAR(error.relative_error(), 0.02 * std::sqrt(2. / 1.25), 1e-12);
    }
}

TEST(StressGoal, RepeatedStepsReplaceAndLimitsAreShared)
{
  const Judged   judged;
  StressError<2> error(0.02);
  Given          stress;
  EXPECT_EQ(error.relative_error(), 0.);
  judged.see(error, stress, 0.1);
  const double once     = error.relative_error();
  stress.sum_of_squares = 16.;
  judged.see(error, stress, 0.1);
  EXPECT_NEAR(error.relative_error(), 8. * once, 1e-12);
  // No cell may become finer: all of them together are half of what others might do.
  EXPECT_NEAR(judged.see(error, stress, 0.1, 3), 0.5, 1e-12);
  stress.size = 0.;
  EXPECT_EQ(judged.see(error, stress, 0.2), 0.);
}

TEST(StressGoal, AFlightIsNoPartOfTheFirstStep)
{
  const Judged   judged;
  StressError<2> error(0.02);
  Given          stress;
  stress.power          = 1.;
  stress.sum_of_squares = 4.;
  judged.see(error, stress, 3.); // the first contact: a relative error of 1 for the step 0.1
  stress.sum_of_squares = 0.;
  judged.see(error, stress, 3.3);
  EXPECT_NEAR(error.relative_error(), 0.5, 1e-12);
}

TEST(StressGoal, ArchiveGoesOn)
{
  const Judged   judged;
  StressError<2> error(0.02), other(0.02);
  Given          stress;
  judged.see(error, stress, 0.1);
  std::stringstream stream;
  {
    Archive archive(static_cast<std::ostream &>(stream));
    error.archive(archive);
  }
  Archive archive(static_cast<std::istream &>(stream));
  other.archive(archive);
  stress.size = 0.1;
  EXPECT_EQ(judged.see(error, stress, 0.3), judged.see(other, stress, 0.3));
  EXPECT_EQ(error.relative_error(), other.relative_error());
}
