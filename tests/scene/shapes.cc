// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A placement is the rigid motion that the keys describe, a cap is part of a sphere, and whatever
// asks a body for points sees it in its place.

#include "scene_file.h"

#include <signorini/model/placed_body.h>
#include <signorini/shapes/cap.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const Point<3> odd_point(0.1, -0.7, 1. / 3.), odd_centre(0.3, 0.9, -1.1);

  template <int dim>
  void expect_near(const Point<dim> &point, const Point<dim> &expected)
  {
    EXPECT_LT(point.distance(expected), 1e-14) << point << " instead of " << expected;
  }

  Scene<3> read_shapes(const std::vector<Override> &overrides)
  {
    const TemporaryFile file(correct_scene());
    return read_scene<3>(file.name, overrides);
  }

  const std::string meshes = SIGNORINI_SOURCE_DIR "/parameters/meshes/";
} // namespace

TEST(Placement, WithoutMotionNothingChanges)
{
  for (const double angle : {0., 360., -720.})
    {
      const Placement<3> placement({{angle, angle, angle}}, odd_centre, Tensor<1, 3>());
      EXPECT_TRUE(placement.is_identity());
      EXPECT_EQ(placement.place(odd_point), odd_point);
      EXPECT_EQ(placement.pull_back(odd_point), odd_point);
    }
  EXPECT_TRUE(Placement<2>().is_identity());
}

TEST(Placement, QuarterTurnsAreExactAndInTheOrderXYZ)
{
  const Point<3> origin, p(0.1, 0.2, 0.3);
  const auto     turned = [&](const std::array<double, 3> &degrees) {
    return Placement<3>(degrees, origin, Tensor<1, 3>()).place(p);
  };
  EXPECT_EQ(turned({{90, 0, 0}}), Point<3>(0.1, -0.3, 0.2));
  EXPECT_EQ(turned({{0, 90, 0}}), Point<3>(0.3, 0.2, -0.1));
  EXPECT_EQ(turned({{0, 0, 90}}), Point<3>(-0.2, 0.1, 0.3));
  EXPECT_EQ(turned({{0, 0, -270}}), Point<3>(-0.2, 0.1, 0.3));
  EXPECT_EQ(turned({{0, 180, 0}}), Point<3>(-0.1, 0.2, -0.3));
  // About x: (0.1, -0.3, 0.2); then about z: (0.3, 0.1, 0.2). The other order gives (-0.2, -0.3,
  // 0.1).
  EXPECT_EQ(turned({{90, 0, 90}}), Point<3>(0.3, 0.1, 0.2));
  EXPECT_EQ(Placement<2>({{90}}, Point<2>(), Tensor<1, 2>()).place(Point<2>(0.1, 0.2)),
            Point<2>(-0.2, 0.1));
}

TEST(Placement, RotatesAboutTheCentreAndMovesAfterwards)
{
  const double       c = std::sqrt(3.) / 2., s = 0.5;
  const Placement<2> placement({{30}}, Point<2>(1., 2.), Tensor<1, 2>({10., 20.}));
  expect_near(placement.place(Point<2>(1., 2.)), Point<2>(11., 22.));
  expect_near(placement.place(Point<2>(2., 2.)), Point<2>(11. + c, 22. + s));
  expect_near(Point<2>(placement.turn(Tensor<1, 2>({1., 0.}))), Point<2>(c, s));

  const Placement<3> general({{10., -200., 33.}}, odd_centre, Tensor<1, 3>({1., 2., 3.}));
  expect_near(general.pull_back(general.place(odd_point)), odd_point);
  EXPECT_NEAR(general.place(odd_point).distance(general.place(odd_centre)),
              odd_point.distance(odd_centre),
              1e-14);
}

TEST(Placement, CentreIsThatOfTheShapeUnlessGiven)
{
  const auto centre_of_box = [](const std::vector<Override> &overrides) {
    return centre_of(read_shapes(overrides).bodies[1]);
  };
  const Override quarter = {"Bodies/box/Rotation", "0, 0, 90"},
                 up      = {"Bodies/box/Translation", "0, 0, 5"};
  expect_near(centre_of_box({quarter}), Point<3>(2.5, 0.5, 1.));
  expect_near(centre_of_box({quarter, up}), Point<3>(2.5, 0.5, 6.));
  expect_near(centre_of_box({quarter, up, {"Bodies/box/Rotation centre", "0, 0, 0"}}),
              Point<3>(-0.5, 2.5, 6.));
}

TEST(Placement, ExpressionsAreTriedWhereTheBodyIs)
{
  // The box fills 2 < x < 3 as described and -1 < x < 0 where it is.
  const TemporaryFile         file(correct_scene());
  const std::vector<Override> there = {{"Bodies/box/Rotation", "0, 0, 90"},
                                       {"Bodies/box/Rotation centre", "0, 0, 0"}};
  std::vector<Override>       here  = there;
  here.emplace_back("Bodies/box/Body force", "0; 0; sqrt(-x)");
  EXPECT_EQ(refusal(file.name, here), "");
  std::vector<Override> wrong = there;
  wrong.emplace_back("Bodies/box/Body force", "0; 0; sqrt(x - 1)");
  expect_words(refusal(file.name, wrong), {"`sqrt(x - 1)`", "not a number"});
  wrong.back() = {"Bodies/box/Traction", "5: 0; 0; sqrt(x - 1)"};
  expect_words(refusal(file.name, wrong), {"`sqrt(x - 1)`", "not a number"});
}

TEST(Cap, IsPartOfASphereAndLeavesTheOppositeFace)
{
  for (const unsigned int face : {0, 1, 2, 3, 4, 5})
    {
      BoxShape<3> box;
      box.lower_corner = Point<3>(1., 2., 3.);
      box.upper_corner = Point<3>(2., 2.8, 4.4);
      box.cap_radius   = 1.5;
      box.cap_boundary = face;
      const Cap<3>       cap(box);
      const unsigned int d      = face / 2;
      const double       side   = face % 2 == 0 ? -1. : 1.;
      Point<3>           centre = box.lower_corner + .5 * (box.upper_corner - box.lower_corner),
               opposite         = centre;
      centre[d]                 = (face % 2 == 0 ? box.lower_corner : box.upper_corner)[d];
      opposite[d]               = (face % 2 == 0 ? box.upper_corner : box.lower_corner)[d];
      Point<3> sphere           = centre;
      sphere[d] -= side * box.cap_radius;
      expect_near(cap.bulge(centre), centre);

      Tensor<1, 3> aside({0.3, -0.2, 0.35});
      aside[d] = 0.;
      EXPECT_NEAR(cap.bulge(centre + aside).distance(sphere), box.cap_radius, 1e-14);
      EXPECT_LT(side * (cap.bulge(centre + aside) - centre)[d], 0.) << "it recedes into the body";
      expect_near(cap.bulge(opposite + aside), Point<3>(opposite + aside));
      // Half way between the faces, half of the way.
      const Point<3> middle = centre + aside + .5 * (opposite - centre);
      expect_near(Point<3>(2. * (cap.bulge(middle) - middle)),
                  Point<3>(cap.bulge(centre + aside) - (centre + aside)));
      expect_near(cap.flatten(cap.bulge(middle)), middle);
    }
}

TEST(MeshFiles, AreFoundFromTheFolderOfTheScene)
{
  const TemporaryFile mesh("4 1 0 0 0\n1 0 0 0\n2 2 0 0\n3 2 1 0\n4 0 1 0\n1 0 quad 1 2 3 4\n",
                           ".UCD");
  const std::string   text =
    "set Dimension = 2\n" + assignment("Time/Step size", "1e-2") + assignment("Time/End time", "1")
    + assignment("Bodies/Names", "plate") + assignment("Bodies/plate/Shape", "file")
    + assignment("Bodies/plate/Rotation", "90") + assignment("Bodies/plate/Translation", "5, 0")
    + assignment("Bodies/plate/File", std::filesystem::path(mesh.name).filename().string());
  const TemporaryFile file(text);
  const Scene<2>      scene = read_scene<2>(file.name, {});
  EXPECT_EQ(mesh_of(scene.bodies[0]).path, mesh.name);
  expect_near(centre_of(scene.bodies[0]), Point<2>(6., 0.5));
  EXPECT_EQ(boundary_points(scene.bodies[0], 0).size(), 4u);

  // The list of all parameters can be run from anywhere.
  const std::string folder = testing::TempDir() + "elsewhere_" + std::to_string(getpid());
  std::filesystem::create_directory(folder);
  std::ofstream(folder + "/parameters.prm") << scene.all_parameters;
  EXPECT_EQ(refusal(folder + "/parameters.prm"), "");
  EXPECT_EQ(read_scene<2>(folder + "/parameters.prm", {}).all_parameters, scene.all_parameters);
  std::filesystem::remove_all(folder);
}

TEST(MeshFiles, HaveTheirOwnBoundaryIds)
{
  using Ids                           = std::vector<dealii::types::boundary_id>;
  const std::vector<Override> anvil   = {{"Bodies/box/Shape", "file"},
                                         {"Bodies/box/File", meshes + "anvil.msh"},
                                         {"Bodies/box/Traction", "2: 0; 0; -1"},
                                         {"Bodies/box/Dirichlet", "1: 0; 0; 0"},
                                         {"Contact/Pairs", "ball : floor, box[3] : pillar"}};
  std::string                 correct = correct_scene();
  correct.replace(correct.find("  subsection box[2, 4] : pillar\n  end\n"), 38, "");
  const TemporaryFile file(correct);
  EXPECT_EQ(refusal(file.name, anvil), "");
  EXPECT_EQ(read_scene<3>(file.name, anvil).bodies[1].shape->boundary_ids(), (Ids{1, 2, 3}));

  std::vector<Override> wrong = anvil;
  wrong.emplace_back("Bodies/box/Dirichlet", "0: 0; 0; 0");
  expect_words(refusal(file.name, wrong),
               {"Bodies/box/Dirichlet",
                "anvil.msh has no boundary id `0`",
                "Valid: 1 (bottom), 2 (top), 3 (sides)."});
  wrong.back() = {"Bodies/box/Traction", "4: 0; 0; 1"};
  expect_words(refusal(file.name, wrong), {"Bodies/box/Traction", "no boundary id `4`"});
  wrong.back() = {"Contact/Pairs", "ball : floor, box[0] : pillar"};
  expect_words(refusal(file.name, wrong),
               {"Contact/Pairs", "no boundary id 0", "Valid: 1 (bottom), 2 (top), 3 (sides)."});
}
