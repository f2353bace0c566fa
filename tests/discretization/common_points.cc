// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// All processes get the points of all of them, bit by bit, in the order of the processes; some
// processes have none.

#include <signorini/discretization/common_points.h>

#include <gtest/gtest.h>

#include <limits>

using namespace signorini;
using dealii::Point;

TEST(CommonPoints, AreThoseOfAllProcessesInTheirOrder)
{
  const unsigned int n_processes = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                     process     = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const auto points_of           = [](const unsigned int p) {
    std::vector<Point<3>> points;
    for (unsigned int k = 0; k < 3 * (p % 2); ++k)
      points.emplace_back(1. / (3. + p), -std::numeric_limits<double>::min(), 1e30 * k);
    return points;
  };
  std::vector<Point<3>> expected;
  for (unsigned int p = 0; p < n_processes; ++p)
    for (const Point<3> &point : points_of(p))
      expected.push_back(point);
  EXPECT_EQ(common_points(points_of(process), MPI_COMM_WORLD), expected);

  const std::vector<Point<2>> own(1, Point<2>(process, -0.1));
  const auto                  found = common_points(own, MPI_COMM_WORLD);
  ASSERT_EQ(found.size(), n_processes);
  for (unsigned int p = 0; p < n_processes; ++p)
    EXPECT_EQ(found[p], Point<2>(p, -0.1));
}
