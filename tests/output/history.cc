// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Each value stands under its own name; probes show friction only in scenes that have some.

#include "box_above_floor.h"
#include "scratch.h"

#include <signorini/base/spelling.h>
#include <signorini/output/history.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  /** The last row of a table by names of columns. */
  std::map<std::string, double> last_row(const std::string &path)
  {
    const std::vector<std::string> lines  = split(contents(path), '\n');
    const std::vector<std::string> names  = split(lines.at(0), ','),
                                   values = split(lines.at(1), ',');
    std::map<std::string, double> row;
    EXPECT_EQ(names.size(), values.size());
    for (unsigned int i = 0; i < names.size(); ++i)
      row[names[i]] = std::stod(values.at(i));
    return row;
  }

  ProbeReading reading_of_a_sliding_node()
  {
    ProbeReading reading;
    reading.normal_force     = 5.;
    reading.tangential_force = {{1., 2., 3.}};
    reading.slip             = {{4., 6., 7.}};
    reading.slip_path        = 8.;
    reading.status           = contact_status::stick;
    return reading;
  }

  std::map<std::string, double> probe_row(const bool with_friction)
  {
    const ScratchFolder         folder;
    const BoxAboveFloor<2>      box(with_friction);
    const std::vector<Probe<2>> probes = {{{"corner", {0., 0.}}, *box.surface, MPI_COMM_WORLD}};
    History<2>                  history(folder.name, false, with_friction, probes, MPI_COMM_WORLD);
    history.write_probe(0, 0.5, reading_of_a_sliding_node(), true);
    MPI_Barrier(MPI_COMM_WORLD);
    return last_row(folder.name + "/probe_corner.csv");
  }
} // namespace

TEST(History, ContactAndFriction)
{
  const ScratchFolder         folder;
  const std::vector<Probe<2>> no_probes;
  History<2>                  history(folder.name, false, true, no_probes, MPI_COMM_WORLD);
  const State                 state;
  HistoryRow                  row{state};
  row.wall_time              = 7.;
  row.booking.friction       = -1.5;
  row.contact.normal_force   = 10.;
  row.contact.friction_force = 3.;
  row.contact.resultant      = {{1., 2., 4.}};
  row.contact.n_active       = 9;
  row.contact.n_stick        = 5;
  row.contact.n_slip         = 6;
  row.contact.max_slip       = 0.25;
  history.write(row, true);
  MPI_Barrier(MPI_COMM_WORLD);
  const auto written = last_row(folder.name + "/history.csv");
  for (const auto &[name, value] : std::map<std::string, double>{{"work_friction", -1.5},
                                                                 {"contact_force", 10.},
                                                                 {"contact_force_z", 4.},
                                                                 {"friction_force", 3.},
                                                                 {"active_nodes", 9.},
                                                                 {"stick_nodes", 5.},
                                                                 {"slip_nodes", 6.},
                                                                 {"max_slip", 0.25},
                                                                 {"wall_time", 7.}})
    EXPECT_EQ(written.at(name), value) << name;
}

TEST(History, ProbesWithFriction)
{
  const auto written = probe_row(true);
  EXPECT_EQ(written.at("normal_force"), 5.);
  EXPECT_EQ(written.at("tangential_force_x"), 1.);
  EXPECT_EQ(written.at("tangential_force_z"), 3.);
  EXPECT_EQ(written.at("slip_y"), 6.);
  EXPECT_EQ(written.at("slip_path"), 8.);
  EXPECT_EQ(written.at("status"), 2.);
}

TEST(History, ProbesWithoutFriction)
{
  const auto written = probe_row(false);
  EXPECT_EQ(written.size(), 6u);
  EXPECT_EQ(written.at("normal_force"), 5.);
}
