// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The summary of a run counts every step, and warns of what makes its results doubtful: only then.

#include <signorini/output/run_summary.h>

#include <gtest/gtest.h>

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
