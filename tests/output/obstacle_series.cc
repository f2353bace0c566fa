// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A moment of the obstacles that move shows them near to where the bodies are then, with half the
// size of one body to spare, however far apart the bodies are. Hanging nodes, which have no
// displacement of their own, do not count.

#include "box_above_floor.h"
#include "scratch.h"

#include <signorini/output/obstacle_series.h>
#include <signorini/output/obstacle_surfaces.h>

#include <gtest/gtest.h>

using namespace signorini;
using dealii::BoundingBox;
using dealii::Point;

namespace
{
  /** Without the line that has the date. */
  std::string without_date(const std::string &file)
  {
    std::istringstream in(file);
    std::string        result;
    for (std::string line; std::getline(in, line);)
      if (line.find("deal.II") == std::string::npos)
        result += line + "\n";
    return result;
  }
} // namespace

TEST(ObstacleSeries, ShowsWhatIsNearEachBody)
{
  Scene<2> scene = box_above_floor<2>();
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name                 = "far";
  box_of(scene.bodies[1]).lower_corner = Point<2>(19., 0.);
  box_of(scene.bodies[1]).upper_corner = Point<2>(20., 1.);
  scene.bodies[1].local_refinements    = 0;
  ObstacleMotion<2>::Description description;
  description.velocity      = {{"t", "0"}};
  scene.obstacles[0].motion = std::make_shared<ObstacleMotion<2>>("floor", description);

  const Mesh<2>           mesh(scene.bodies, MPI_COMM_WORLD);
  const Discretization<2> discretization(mesh);
  State                   state;
  state.time         = 2.;
  state.step         = 3;
  state.displacement = discretization.interpolate({{{"0", "0.5"}}, {{"0", "0.5"}}});
  const ScratchFolder folder;
  ObstacleSeries<2>(folder.name, scene.obstacles, MPI_COMM_WORLD).write(state, discretization);
  MPI_Barrier(MPI_COMM_WORLD);

  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
    return;
  const auto                        shown  = shown_obstacles(scene.obstacles, true, state.time);
  const std::vector<BoundingBox<2>> bodies = {
    BoundingBox<2>({Point<2>(0., 0.5), Point<2>(1., 1.5)}),
    BoundingBox<2>({Point<2>(19., 0.5), Point<2>(20., 1.5)})};
  ObstacleSurfaces<2>           expected(shown, surroundings(bodies, shown));
  dealii::DataOutBase::VtkFlags flags(state.time, state.step);
  flags.compression_level = decltype(flags.compression_level)::best_speed;
  expected.set_flags(flags);
  std::ostringstream file;
  expected.write_vtu(file);
  EXPECT_EQ(without_date(contents(folder.name + "/fields/obstacles_000003.0.vtu")),
            without_date(file.str()));
  double first = 0., last = 0.;
  for (const auto &patch : expected.get_patches())
    for (const Point<2> &vertex : patch.vertices)
      {
        first = std::min(first, vertex[0]);
        last  = std::max(last, vertex[0]);
      }
  EXPECT_NEAR(first, -std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(last, 20. + std::sqrt(0.5), 1e-12);
}
