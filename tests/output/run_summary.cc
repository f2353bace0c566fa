// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The summary of a run counts every step, and warns of what makes its results doubtful: only then.

#include <signorini/diagnostics/resolution.h>
#include <signorini/output/run_summary.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace signorini;

namespace
{
  /** A row with energy of motion 2 and a force of 3 in a step of length 0.5. */
  HistoryRow pressed(const State &state)
  {
    HistoryRow row{state};
    row.energy.kinetic       = 1.5;
    row.energy.elastic       = 0.5;
    row.cells                = 10;
    row.report.step_size     = 0.5;
    row.contact.normal_force = 3.;
    row.contact.n_active     = 1;
    return row;
  }

  std::string warnings_of(const HistoryRow &row, const RunSubject &subject = {})
  {
    RunSummary summary(subject);
    summary.start(row);
    summary.add(row);
    std::string all;
    for (const std::string &warning : summary.warnings())
      all += warning + "\n";
    return all;
  }
} // namespace

TEST(RunSummary, SumsOverAllSteps)
{
  State      state;
  HistoryRow row = pressed(state);
  RunSummary summary({});
  summary.start(row);
  for (unsigned int step = 1; step <= 4; ++step)
    {
      state.time = 0.5 * step;
      row.energy.kinetic -= 0.1;
      summary.add(row);
    }
  summary.change_mesh(4);
  summary.change_mesh(12);
  EXPECT_NEAR(summary.relative_energy_change(), -0.2, 1e-14);
  const std::string text = summary.text();
  for (const char *part : {"changed by -20 %",
                           "from 0.5 to 2, largest force 3, impulse 6",
                           "changed 2 times, between 4 and 12 cells"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(RunSummary, VibrationsThatStepsInFlightLoseAreToldIfContactComesBack)
{
  const auto text = [](const double flight_step, const double elastic, const bool comes_back) {
    State      state;
    RunSubject subject;
    subject.has_inertia = true;
    RunSummary summary(subject);
    summary.start(pressed(state));
    const auto add = [&](const HistoryRow &row) {
      state.time += row.report.step_size;
      summary.add(row);
    };
    for (unsigned int phase = 0; phase < (comes_back ? 2 : 1); ++phase)
      {
        for (unsigned int step = 0; step < 5; ++step)
          add(pressed(state));
        HistoryRow flight       = pressed(state);
        flight.report.step_size = flight_step;
        flight.energy.elastic   = elastic;
        flight.contact          = {};
        add(flight);
        add(flight);
      }
    return summary.text();
  };
  const auto says = [&](const double flight_step, const double elastic, const bool comes_back) {
    return text(flight_step, elastic, comes_back).find("long steps in flight") != std::string::npos;
  };
  EXPECT_TRUE(says(5., 0.1, true));
  EXPECT_FALSE(says(5., 0.1, false)) << "nothing comes after the flight";
  EXPECT_FALSE(says(5., 1e-6, true)) << "nothing vibrates";
  EXPECT_FALSE(says(1., 0.1, true)) << "steps resolve what contact does";
}

TEST(RunSummary, EnergyIsMeasuredByThatOfTheMotionIfItBeginsAtRest)
{
  const State      state;
  const HistoryRow start{state};
  RunSummary       summary({});
  summary.start(start);
  HistoryRow row = pressed(state);
  summary.add(row);
  EXPECT_DOUBLE_EQ(summary.relative_energy_change(), 1.);
}

namespace
{
  /** Energies of a state, and what has been booked since the one before. */
  HistoryRow energies(const State &state, const double motion, const double external = 0.)
  {
    HistoryRow row{state};
    row.energy.kinetic  = motion;
    row.energy.external = external;
    return row;
  }

  double change_of(const std::vector<HistoryRow> &rows)
  {
    RunSummary summary({});
    summary.start(rows[0]);
    for (std::size_t k = 1; k < rows.size(); ++k)
      summary.add(rows[k]);
    return summary.relative_energy_change();
  }
} // namespace

// Changes are parts of what there was to lose: of the energy of the motion, or of the work that
// came from outside.
TEST(RunSummary, EnergyIsMeasuredByTheLargestThereWas)
{
  const State state;
  EXPECT_DOUBLE_EQ(change_of({energies(state, 2.), energies(state, 1.)}), -0.5) << "free";
  EXPECT_DOUBLE_EQ(change_of({energies(state, 1.), energies(state, 3., -3.)}), -1. / 3.)
    << "thrown, falls by 3";
  EXPECT_DOUBLE_EQ(change_of({energies(state, 1., -7.), energies(state, 1., -10.)}), -1.)
    << "slides down a slope without getting faster, and the reference of heights is no matter";
  EXPECT_NEAR(change_of({energies(state, 1., -2.), energies(state, 0.9, -2.)}), -0.1, 1e-14)
    << "released from under a load";

  // An arm that is slow at the start is driven by 5, and friction takes 4 of it.
  HistoryRow driven       = energies(state, 1.01);
  driven.booking.external = 5.;
  driven.booking.friction = -4.;
  EXPECT_DOUBLE_EQ(change_of({energies(state, 0.01), driven}), 1. / 5.);
  // A load that turns its sign while the body is 10 units away does no work.
  HistoryRow turned       = energies(state, 1., 10.);
  turned.booking.external = 20.;
  EXPECT_DOUBLE_EQ(change_of({energies(state, 1., -10.), turned}), 20.);
}

// Gaps between bodies that are missed by more than a hundredth of the energy are warned of; the sum
// over the steps would grow with their number.
TEST(RunSummary, MissedGapsAreThoseOfAStep)
{
  const State state;
  HistoryRow  row      = pressed(state);
  row.booking.geometry = -0.016; // of an energy of 2
  const auto text_of   = [&](const unsigned int n_steps) {
    RunSummary summary({});
    summary.start(row);
    for (unsigned int step = 0; step < n_steps; ++step)
      summary.add(row);
    EXPECT_TRUE(n_steps < few_steps || summary.warnings().empty());
    return summary.text();
  };
  EXPECT_NE(text_of(20).find("0.8 % of the energy in a step"), std::string::npos) << text_of(20);
  row.booking.geometry = 1e-5;
  EXPECT_EQ(text_of(1).find("missed gaps"), std::string::npos);
  row.booking.geometry = -0.03;
  EXPECT_NE(warnings_of(row).find("up to 1.5 % of the energy in a step"), std::string::npos);
  EXPECT_NE(warnings_of(row).find("smaller steps do not"), std::string::npos);
}

TEST(RunSummary, WarnsOfWhatIsDoubtful)
{
  const State state;
  EXPECT_EQ(warnings_of(pressed(state)), "");

  HistoryRow unexplained       = pressed(state);
  unexplained.booking.residual = -1e-5;
  EXPECT_NE(warnings_of(unexplained).find("report it"), std::string::npos);
  RunSubject subject;
  subject.own_tolerance = "Reference tolerance";
  EXPECT_NE(warnings_of(unexplained, subject).find("Reduce `Reference tolerance`"),
            std::string::npos);

  HistoryRow pole       = pressed(state);
  pole.contact.n_nodes  = 30;
  pole.contact.n_active = 8;
  EXPECT_NE(warnings_of(pole).find("only 8 of 30 contact nodes"), std::string::npos);
  subject           = {};
  subject.dimension = 2;
  EXPECT_EQ(warnings_of(pole, subject), "");
  pole.contact.n_nodes = 12;
  EXPECT_EQ(warnings_of(pole), "") << "most of a small flat face";

  HistoryRow lossy      = pressed(state);
  lossy.booking.contact = -0.15;
  EXPECT_EQ(warnings_of(lossy), "");
  lossy.booking.predictor = -0.1;
  EXPECT_NE(warnings_of(lossy).find("contact took 12.5 % of the energy, in 1 steps"),
            std::string::npos);
}

TEST(RunSummary, WarnsOfEnergyThatChangesOfTheMeshBringOrTake)
{
  State state;
  state.time     = 0.25;
  HistoryRow row = pressed(state);
  for (const double transfer : {-0.19, 0.009})
    {
      row.booking.transfer = transfer;
      EXPECT_EQ(warnings_of(row).find("of the mesh"), std::string::npos) << transfer;
    }
  row.booking.transfer = 0.04;
  EXPECT_NE(warnings_of(row).find(
              "changes of the mesh brought 2 % of the energy, that before time 0.25 2 %"),
            std::string::npos)
    << warnings_of(row);
  // What others bring is no excuse for what some take.
  RunSummary summary({});
  summary.start(row);
  for (const double transfer : {-0.15, 0.009, -0.15})
    {
      row.booking.transfer = transfer;
      summary.add(row);
    }
  const auto warnings = summary.warnings();
  EXPECT_EQ(std::count_if(warnings.begin(),
                          warnings.end(),
                          [](const std::string &warning) {
                            return warning.find("changes of the mesh took 15 % of the energy")
                                   != std::string::npos;
                          }),
            1);
}

// A contact of a few steps is judged when it has ended, not when the run ends in the middle of it.
TEST(RunSummary, WarnsOfAContactOfAFewSteps)
{
  const State state;
  HistoryRow  row   = pressed(state);
  HistoryRow  apart = row;
  apart.contact     = {};
  for (const unsigned int n_steps : {1, 7, 8})
    {
      RunSummary summary({});
      summary.start(apart);
      for (unsigned int step = 0; step < n_steps; ++step)
        summary.add(row);
      EXPECT_TRUE(summary.warnings().empty());
      summary.add(apart);
      EXPECT_EQ(summary.warnings().size(), n_steps < 8 ? 1u : 0u) << n_steps;
    }
}
