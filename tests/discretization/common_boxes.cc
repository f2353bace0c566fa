// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The boxes around points of all processes are those around the points on one, whoever has them;
// some processes have none.

#include <signorini/discretization/common_boxes.h>

#include <gtest/gtest.h>

using namespace signorini;
using dealii::Point;

TEST(CommonBoxes, AreAroundThePointsOfAllProcesses)
{
  const std::vector<std::vector<Point<3>>> points = {
    {Point<3>(-3., -1., 2.), Point<3>(-2., -4., 5.), Point<3>(-2.5, -2., -1.)},
    {Point<3>(7., 8., 9.)},
    {Point<3>(0., 1., 0.), Point<3>(1., 0., -1e-3)}};
  const unsigned int n_processes = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                     process     = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  CommonBoxes<3> boxes(points.size());
  for (unsigned int box = 0; box < points.size(); ++box)
    for (unsigned int k = 0; k < points[box].size(); ++k)
      if ((box + k) % n_processes == process)
        boxes.add(points[box][k], box);
  const auto found = boxes.around_all(MPI_COMM_WORLD);
  ASSERT_EQ(found.size(), points.size());
  for (unsigned int box = 0; box < points.size(); ++box)
    EXPECT_EQ(found[box].get_boundary_points(),
              dealii::BoundingBox<3>(points[box]).get_boundary_points());
}
