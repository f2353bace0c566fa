// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The drawn surface of an obstacle lies on the obstacle, and all of it that is in the box is there:
// a plane has the area of its section of the box, also where it passes through vertices of the
// grid, and a sphere or circle its own up to the error of facets (relative, of second order in the
// size of the grid); what has facets is drawn with these. Where an expression has no value or no
// gradient nothing is drawn, and the rest is. Obstacles that move are drawn where they are.

#include "scratch.h"

#include <signorini/obstacles/level_set.h>
#include <signorini/obstacles/mesh_obstacle.h>
#include <signorini/obstacles/plane.h>
#include <signorini/obstacles/round_obstacle.h>
#include <signorini/output/obstacle_surfaces.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

using namespace signorini;
using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

namespace
{
  template <int dim>
  NamedObstacle<dim> plane(const Tensor<1, dim> &normal)
  {
    return {"plane", std::make_shared<Plane<dim>>(Point<dim>(), normal)};
  }

  template <int dim>
  NamedObstacle<dim> sphere(const double radius)
  {
    return {"sphere",
            std::make_shared<RoundObstacle<dim>>(Point<dim>(), Tensor<1, dim>(), radius, false)};
  }

  template <int dim>
  NamedObstacle<dim> function(const std::string &expression)
  {
    return {"function", std::make_shared<LevelSet<dim>>("function", expression)};
  }

  /** From (-1, ...) to (1, ...), which makes the origin a vertex of the grid. */
  template <int dim>
  BoundingBox<dim> box()
  {
    Point<dim> lower, upper;
    for (unsigned int c = 0; c < dim; ++c)
      {
        lower[c] = -1.;
        upper[c] = 1.;
      }
    return BoundingBox<dim>({lower, upper});
  }

  /** Length of lines, area of triangles. */
  double measure(const dealii::DataOutBase::Patch<1, 2> &patch)
  {
    return patch.vertices[0].distance(patch.vertices[1]);
  }

  double measure(const dealii::DataOutBase::Patch<2, 3> &patch)
  {
    return 0.5
           * dealii::cross_product_3d(patch.vertices[1] - patch.vertices[0],
                                      patch.vertices[2] - patch.vertices[0])
               .norm();
  }

  template <int dim>
  void expect_surfaces(const std::vector<NamedObstacle<dim>> &obstacles,
                       const std::vector<double>             &areas)
  {
    const ObstacleSurfaces<dim> surfaces(shown_obstacles(obstacles, false), box<dim>());
    std::vector<double>         found(areas.size(), 0.);
    for (const auto &patch : surfaces.get_patches())
      {
        const unsigned int index = patch.data(0, 0);
        found.at(index) += measure(patch);
        for (unsigned int v = 0; v < dim; ++v)
          EXPECT_LT(std::abs(obstacles[index].shape->project(patch.vertices[v]).gap), 1e-12);
      }
    for (unsigned int i = 0; i < areas.size(); ++i)
      EXPECT_NEAR(found[i], areas[i], 5e-3 * areas[i]) << obstacles[i].name;
  }
} // namespace

TEST(ObstacleSurfaces, LinesInThePlane)
{
  expect_surfaces<2>({plane<2>(Point<2>(0., 1.)), plane<2>(Point<2>(1., -1.)), sphere<2>(0.5)},
                     {2., 2. * std::sqrt(2.), M_PI});
}

TEST(ObstacleSurfaces, TrianglesInSpace)
{
  expect_surfaces<3>({plane<3>(Point<3>(0., 0., 1.)), sphere<3>(0.5)}, {4., M_PI});
}

// A hole has no normal in its middle, which is a vertex of the grid. The plane has no value left of
// -0.505, and is drawn in the cells from -0.5 on.
TEST(ObstacleSurfaces, FunctionsThatAreNotKnownEverywhere)
{
  const std::string half = " + 0*sqrt(x + 0.505)";
  expect_surfaces<2>({function<2>("0.5 - sqrt(x^2 + y^2)"), function<2>("y - 0.1" + half)},
                     {M_PI, 1.5});
  expect_surfaces<3>({function<3>("0.5 - sqrt(x^2 + y^2 + z^2)"), function<3>("z - 0.1" + half)},
                     {M_PI, 3.});
}

TEST(ObstacleSurfaces, AFileWithAllOfThem)
{
  const ScratchFolder folder;
  write_obstacles<3>(folder.name, {box<3>()}, {sphere<3>(0.5)}, MPI_COMM_WORLD);
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string text = contents(folder.name + "/obstacles.vtu");
  EXPECT_NE(text.find("Name=\"obstacle\""), std::string::npos);
  EXPECT_NE(text.find("</VTKFile>"), std::string::npos);
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST(ObstacleSurfaces, ObstaclesThatMoveAreWhereTheyAre)
{
  ObstacleMotion<2>::Description description;
  description.velocity          = {{"t", "0"}};
  description.angular_velocity  = "1";
  const auto             motion = std::make_shared<ObstacleMotion<2>>("any", description);
  const FacetMesh<2>     triangle{{{0., 0.}, {1., 0.}, {0., 1.}}, {{{0, 1}}, {{1, 2}}, {{2, 0}}}};
  const NamedObstacle<2> rests = sphere<2>(0.5),
                         turns{"plane", plane<2>(Point<2>(0., 1.)).shape, motion},
                         facets{"mesh",
                                std::make_shared<MeshObstacle<2>>(
                                  std::make_shared<FacetedSurface<2>>(triangle, false)),
                                motion};
  const std::vector<NamedObstacle<2>> all    = {rests, turns, facets};
  const double                        time   = 0.7;
  const auto                          moving = shown_obstacles(all, true, time);
  ASSERT_EQ(moving.size(), 2u);
  EXPECT_EQ(moving[1].index, 2u);
  EXPECT_EQ(shown_obstacles(all, false, time).size(), 1u);

  const ObstacleSurfaces<2> surfaces(moving, box<2>());
  double                    length   = 0.;
  unsigned int              n_facets = 0;
  for (const auto &patch : surfaces.get_patches())
    for (unsigned int v = 0; v < 2; ++v)
      {
        const Point<2>          start = motion->place(time).back(patch.vertices[v]);
        const NamedObstacle<2> &shown = all.at(patch.data(0, 0));
        EXPECT_LT(std::abs(shown.shape->project(start).gap), 1e-12);
        n_facets += patch.data(0, 0) == 2.;
        length += patch.data(0, 0) == 2. ? 0.5 * measure(patch) : 0.;
      }
  EXPECT_EQ(n_facets, 6u);
  EXPECT_NEAR(length, 2. + std::sqrt(2.), 1e-14); // all of it, also out of the box
}

TEST(ObstacleSurfaces, TheSurroundingsReachTheObstacle)
{
  const NamedObstacle<2> floor{"floor",
                               std::make_shared<Plane<2>>(Point<2>(0., -9.), Point<2>(0., 1.))};
  const auto             corners =
    surroundings<2>({box<2>()}, shown_obstacles<2>({floor}, false)).get_boundary_points();
  EXPECT_LT(corners.first[1], -9.);
  EXPECT_GT(corners.second[1], 1.);
}

// From the centre of the body, which is that of the hole, no point of it is the nearest; from the
// corners there is one. Of the other function nothing is known about the body.
TEST(ObstacleSurfaces, TheSurroundingsOfABodyInAHole)
{
  const BoundingBox<2> body({Point<2>(-0.5, -0.5), Point<2>(0.5, 0.5)});
  for (const auto &obstacles :
       {std::vector<NamedObstacle<2>>{function<2>("2 - sqrt(x^2 + y^2)")},
        {function<2>("y + log(x - 3)"), function<2>("2 - sqrt(x^2 + y^2)")}})
    {
      const auto corners =
        surroundings<2>({body}, shown_obstacles<2>(obstacles, false)).get_boundary_points();
      for (unsigned int c = 0; c < 2; ++c)
        {
          EXPECT_LT(corners.first[c], -2.);
          EXPECT_GT(corners.second[c], 2.);
        }
    }
}
