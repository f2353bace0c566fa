// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The shipped meshes have the volume and the areas that tools/make_meshes.py intends, before and
// after refinement and in any place. Meshes of many cells are accepted, up to what every process
// can keep; beyond that there is a message, and no attempt.

#include "../output/scratch.h"
#include "shapes.h"

#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  BodyDescription<3> body_of(const std::string &file)
  {
    BodyDescription<3> body;
    body.name  = "body";
    body.shape = std::make_shared<MeshFileShape<3>>(
      describe_mesh_file<3>(SIGNORINI_SOURCE_DIR "/parameters/meshes/" + file));
    return body;
  }

  void expect_areas(const std::map<unsigned int, double> &areas,
                    const std::map<unsigned int, double> &expected)
  {
    ASSERT_EQ(areas.size(), expected.size());
    for (const auto &[id, area] : expected)
      {
        ASSERT_EQ(areas.count(id), 1u) << "boundary id " << id;
        EXPECT_NEAR(areas.at(id), area, 1e-7) << "boundary id " << id;
      }
  }

  /** Lateral area of the frustum of a regular pyramid with n sides. */
  double frustum_area(const unsigned int n, const double r, const double R, const double height)
  {
    const double pi = dealii::numbers::PI;
    return n * std::sin(pi / n) * (r + R) * std::hypot(height, (R - r) * std::cos(pi / n));
  }

  double frustum_volume(const unsigned int n, const double r, const double R, const double height)
  {
    return polygon_area(n) * (r * r + r * R + R * R) * height / 3.;
  }

  /** A rectangle of nx x ny unit squares as Gmsh writes it; boundary id 1 below. */
  std::string gmsh_rectangle(const unsigned int nx, const unsigned int ny)
  {
    std::ostringstream file;
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << (nx + 1) * (ny + 1) << '\n';
    const auto node = [&](const unsigned int x, const unsigned int y) {
      return y * (nx + 1) + x + 1;
    };
    for (unsigned int y = 0; y <= ny; ++y)
      for (unsigned int x = 0; x <= nx; ++x)
        file << node(x, y) << ' ' << x << ' ' << y << " 0\n";
    file << "$EndNodes\n$Elements\n" << nx + nx * ny << '\n';
    unsigned int element = 0;
    for (unsigned int x = 0; x < nx; ++x)
      file << ++element << " 1 2 1 1 " << node(x, 0) << ' ' << node(x + 1, 0) << '\n';
    for (unsigned int y = 0; y < ny; ++y)
      for (unsigned int x = 0; x < nx; ++x)
        file << ++element << " 3 2 7 7 " << node(x, y) << ' ' << node(x + 1, y) << ' '
             << node(x + 1, y + 1) << ' ' << node(x, y + 1) << '\n';
    file << "$EndElements\n";
    return file.str();
  }

  template <int dim>
  std::string refusal(const BodyDescription<dim> &body)
  {
    try
      {
        const Meshed<dim> meshed(body);
      }
    catch (const UserError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(MeshFiles, AnvilIsAFrustum)
{
  for (const unsigned int refinements : {0, 1})
    {
      BodyDescription<3> body = body_of("anvil.msh");
      body.refinements        = refinements;
      body.placement =
        Placement<3>({{20., 0., 50.}}, mesh_of(body).centre, Tensor<1, 3>({1., 2., 3.}));
      const Meshed<3> meshed(body);
      EXPECT_EQ(meshed.triangulation.n_global_active_cells(), 150u << (3 * refinements));
      EXPECT_NEAR(volume(meshed.triangulation), 0.48 * 19. / 3., 1e-7);
      // 1 bottom, 2 top, 3 sides: two with mean width 1.5 and two with 2.
      expect_areas(boundary_areas(meshed.triangulation),
                   {{1, 4. * 1.2 * 0.9},
                    {2, 4. * 0.8 * 0.6},
                    {3, 2. * 1.5 * std::hypot(1., 0.4) + 2. * 2. * std::hypot(1., 0.3)}});
    }
}

TEST(MeshFiles, HammerIsABarWithANose)
{
  for (const unsigned int refinements : {0, 1})
    {
      BodyDescription<3> body = body_of("hammer.inp");
      body.refinements        = refinements;
      const Meshed<3> meshed(body);
      const auto      areas = boundary_areas(meshed.triangulation);
      const double    disc = polygon_area(16), r = 0.3, R = 0.6;
      EXPECT_EQ(meshed.triangulation.n_global_active_cells(), 192u << (3 * refinements));
      ASSERT_EQ(areas.size(), 4u);
      EXPECT_NEAR(areas.at(3), frustum_area(16, R, R, 1.), 1e-7);
      EXPECT_NEAR(areas.at(4), disc * R * R, 1e-7);
      // The rim of the domed face lies back by this.
      const double back = 1. - std::sqrt(1. - r * r), middle = 0.45;
      EXPECT_NEAR(areas.at(2),
                  frustum_area(16, r, middle, 0.25 - back) + frustum_area(16, middle, R, 0.25),
                  1e-7);
      EXPECT_NEAR(areas.at(1), disc * r * r * (1. + r * r / 4.), 1e-3)
        << "the dome is larger than its shadow";
      const double nose =
        frustum_volume(16, r, middle, 0.25 - back) + frustum_volume(16, middle, R, 0.25);
      const double dome = disc * r * r * back / 2.;
      EXPECT_NEAR(volume(meshed.triangulation), disc * R * R + nose + dome, 5e-4);
    }
}

TEST(MeshFiles, HammerFaceTouchesTheOriginAndItsSurfacesAreWhereTheyShouldBe)
{
  const MeshFile<3> hammer = mesh_of(body_of("hammer.inp"));
  double            tip    = 1.;
  for (const Point<3> &vertex : hammer.boundary_vertices.at(1))
    {
      const Point<3> centre(1., 0., 0.);
      EXPECT_NEAR(vertex.distance(centre), 1., 1e-8) << "the dome is part of a sphere";
      tip = std::min(tip, vertex.norm());
    }
  EXPECT_EQ(tip, 0.);
  for (const Point<3> &vertex : hammer.boundary_vertices.at(4))
    EXPECT_EQ(vertex[0], 1.5);
  EXPECT_NEAR(hammer.centre[0], 0.75, 1e-14);
}

TEST(MeshFiles, ManyCellsAreAccepted)
{
  const ScratchFolder folder;
  const std::string   path = folder.name + "/rectangle.msh";
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::ofstream(path) << gmsh_rectangle(300, 150);
  MPI_Barrier(MPI_COMM_WORLD);
  BodyDescription<2> body;
  body.name  = "body";
  body.shape = std::make_shared<MeshFileShape<2>>(describe_mesh_file<2>(path));
  const Meshed<2> meshed(body);
  EXPECT_EQ(meshed.triangulation.n_global_active_cells(), 45000u);
  EXPECT_NEAR(volume(meshed.triangulation), 45000., 1e-6);
  EXPECT_NEAR(boundary_areas(meshed.triangulation).at(1), 300., 1e-9);
}

// Differences of coordinates would leave no cells, or their products overflow.
TEST(MeshFiles, BodiesWithoutSizeBesideTheirCoordinatesAreRefused)
{
  BodyDescription<3> far = box<3>(), huge = box<3>(), near = box<3>();
  for (const double distance : {1e9, 1e23})
    {
      box_of(far).lower_corner[0] = distance;
      box_of(far).upper_corner[0] = distance + distance * 1e-9;
      EXPECT_NE(refusal(far).find("Bodies/box: it is "), std::string::npos) << refusal(far);
    }
  BodyDescription<3> far_ball = ball<3>(1);
  ball_of(far_ball).centre[1] = 1e20;
  EXPECT_NE(refusal(far_ball).find("Bodies/ball: it is "), std::string::npos) << refusal(far_ball);
  box_of(huge).upper_corner[0] = 1e308;
  EXPECT_NE(refusal(huge).find("coordinates up to 1e+308"), std::string::npos) << refusal(huge);
  box_of(near).lower_corner[0] += 1e5;
  box_of(near).upper_corner[0] += 1e5;
  EXPECT_EQ(refusal(near), "");
}

// One direction is enough, and it is the size that counts, not the unit.
TEST(MeshFiles, FlatBodiesAreRefusedAndSmallOnesAreNot)
{
  for (const unsigned int direction : {0, 1})
    {
      BodyDescription<2> flat = box<2>(), small = box<2>();
      box_of(flat).lower_corner            = Point<2>();
      box_of(flat).upper_corner            = Point<2>(1., 1.);
      box_of(flat).upper_corner[direction] = 1e-9;
      EXPECT_NE(refusal(flat).find("it is 1e-09 thick and has coordinates up to 1."),
                std::string::npos)
        << refusal(flat);
      box_of(flat).upper_corner[direction] = 1e-7;
      EXPECT_EQ(refusal(flat), "");
      box_of(small).lower_corner = Point<2>();
      box_of(small).upper_corner = Point<2>(1e-51, 1e-51);
      EXPECT_NE(refusal(small).find("between 1e-50 and 1e+50"), std::string::npos)
        << refusal(small);
      box_of(small).upper_corner = Point<2>(1e-40, 1e-40);
      EXPECT_EQ(refusal(small), "");
    }
}

// A node that is far away by mistake makes a body that is flat beside its place.
TEST(MeshFiles, MeshesWithANodeFarAwayAreRefused)
{
  const ScratchFolder folder;
  const std::string   path = folder.name + "/rectangle.msh";
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      std::string       text = gmsh_rectangle(1, 1);
      const std::string node = "\n2 1 0 0\n";
      std::ofstream(path) << text.replace(text.find(node), node.size(), "\n2 2e8 0 0\n");
    }
  MPI_Barrier(MPI_COMM_WORLD);
  BodyDescription<2> body;
  body.name  = "body";
  body.shape = std::make_shared<MeshFileShape<2>>(describe_mesh_file<2>(path));
  EXPECT_NE(refusal(body).find("Bodies/body: it is 1 thick and has coordinates up to 2e+08."),
            std::string::npos)
    << refusal(body);
}

TEST(MeshFiles, CoarseCellsThatNoProcessCanKeepAreRefusedBeforeTheyAreMade)
{
  BodyDescription<2> square = box<2>();
  BodyDescription<3> cube   = box<3>();
  for (const unsigned int repetitions : {1001, 1000000})
    {
      box_of(square).repetitions = {{repetitions, 1000}};
      box_of(cube).repetitions   = {{repetitions, 10, 100}};
      for (const std::string &message : {refusal(square), refusal(cube)})
        EXPECT_NE(message.find("Bodies/box/Repetitions gives more than 1000000 coarse cells"),
                  std::string::npos)
          << message;
    }
}
