// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The table of shapes is all that a scene knows: what is added is chosen, listed and checked like
// the shapes that are there, and a name is given once.

#include "../scene/scene_file.h"

#include <signorini/shapes/shape_table.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <set>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** Of a shape for tests: a ball that is known by its diameter. */
  void declare_pellet(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Diameter", "1", dealii::Patterns::Double(), "Pellet: its diameter.");
  }

  std::shared_ptr<const BodyShape<3>> parse_pellet(const SectionReader &in)
  {
    const auto ball = std::make_shared<BallShape<3>>();
    ball->centre    = in.point<3>("Centre");
    ball->radius    = in.number("Diameter") / 2.;
    return ball;
  }

  BodyShapeKind<3> pellet(const char *name)
  {
    return {
      name, "pellets", "pellet (a test)", declare_pellet, {"Centre", "Diameter"}, parse_pellet};
  }

  template <int dim>
  void check_keys()
  {
    std::set<std::string> names;
    for (const BodyShapeKind<dim> &kind : body_shapes<dim>())
      EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    dealii::ParameterHandler prm;
    for (const BodyShapeKind<dim> &kind : body_shapes<dim>())
      kind.declare(prm);
    declare_cap<dim>(prm);
    for (const BodyShapeKind<dim> &kind : body_shapes<dim>())
      for (const std::string &key : kind.keys)
        EXPECT_NO_THROW(prm.get(key)) << kind.name << ": " << key;
  }
} // namespace


TEST(ShapeTable, HasEveryNameOnceAndDeclaresAllKeys)
{
  check_keys<2>();
  check_keys<3>();
}


TEST(ShapeTable, RefusesANameThatIsTaken)
{
  for (const char *name : {"ball", "file"})
    try
      {
        add_body_shape(pellet(name));
        FAIL() << name;
      }
    catch (const UserError &error)
      {
        expect_words(error.what(), {"there is a shape of bodies", "`" + std::string(name) + "`"});
      }
}


TEST(ShapeTable, KnowsWhatIsAddedEverywhere)
{
  const TemporaryFile         file(correct_scene());
  const std::vector<Override> chosen  = {{"Bodies/ball/Shape", "pellet"},
                                         {"Bodies/ball/Diameter", "1.5"}};
  const std::vector<Override> unknown = {{"Bodies/ball/Shape", "pelet"}};
  expect_words(refusal(file.name, unknown),
               {"Bodies/ball/Shape", "Valid: ball, box, cylinder, file."});

  add_body_shape(pellet("pellet"));
  expect_words(refusal(file.name, unknown),
               {"Did you mean `pellet`?", "Valid: ball, box, cylinder, file, pellet."});
  const Scene<3> scene = read_scene<3>(file.name, chosen);
  EXPECT_EQ(scene.bodies[0].shape_name, "pellet");
  EXPECT_DOUBLE_EQ(ball_of(scene.bodies[0]).radius, 0.75);
  EXPECT_DOUBLE_EQ(ball_of(scene.bodies[0]).centre[2], 1.);
  EXPECT_NE(scene.all_parameters.find("Diameter"), std::string::npos);

  // Keys that others look at are refused, and those that they share are theirs, too.
  expect_words(refusal(file.name, {{"Bodies/ball/Diameter", "3"}}),
               {"Bodies/ball/Diameter = 3: is only for pellets", "`Shape = ball`"});
  expect_words(refusal(file.name, {{"Bodies/box/Centre", "1, 2, 3"}}),
               {"is only for balls, cylinders and pellets", "`Shape = box`"});
  expect_words(
    refusal(file.name, {{"Bodies/ball/Shape", "pellet"}, {"Bodies/ball/Dirichlet", "3: 0; 0; 0"}}),
    {"a pellet has no boundary id `3`", "Valid: 0."});
}
