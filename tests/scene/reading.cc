// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A correct scene arrives in the data as it was written.

#include "scene_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  Scene<3> read(const std::vector<Override> &overrides = {})
  {
    const TemporaryFile file(correct_scene());
    return read_scene<3>(file.name, overrides);
  }

  double gap(const Scene<3> &scene, const unsigned int obstacle, const dealii::Point<3> &point)
  {
    return scene.obstacles[obstacle].shape->project(point).gap;
  }
} // namespace

// Cells with straight edges would keep the facets of the first mesh.
TEST(Reading, RoundBodiesAreCurvedOnAMeshThatChanges)
{
  const std::vector<Override> changing = {{"Adaptivity/Indicator", "kelly"},
                                          {"Adaptivity/Maximum level", "4"}},
                              box      = {{"Bodies/ball/Shape", "box"}},
                              linear   = {{"Mapping", "linear"}};
  const auto mapping = [&](std::vector<Override> overrides, const std::vector<Override> &more) {
    overrides.insert(overrides.end(), more.begin(), more.end());
    return read(overrides).mapping;
  };
  EXPECT_EQ(mapping({}, {}), CellGeometry::linear) << "a mesh that stays";
  EXPECT_EQ(mapping(changing, {}), CellGeometry::curved);
  EXPECT_EQ(mapping(changing, box), CellGeometry::linear);
  EXPECT_EQ(mapping(changing, linear), CellGeometry::linear) << "as it is said";
  EXPECT_EQ(mapping({}, {{"Mapping", "curved"}}), CellGeometry::curved);
}

TEST(Reading, TimeAndTopLevel)
{
  const Scene<3> scene = read();
  EXPECT_EQ(scene.output_directory, "output/test");
  EXPECT_EQ(scene.mapping, CellGeometry::linear);
  EXPECT_EQ(scene.time.scheme, "contact-stabilized-projected");
  EXPECT_EQ(scene.time.mass.kind, MassKind::consistent);
  EXPECT_EQ(scene.time.mass.predictor, PredictorMass::consistent);
  EXPECT_DOUBLE_EQ(scene.time.step_size, 5e-3);
  EXPECT_EQ(scene.time.n_steps(), 100u);
  EXPECT_EQ(scene.original_text, correct_scene());
}

TEST(Reading, NumberOfStepsIsRounded)
{
  TimeParameters time;
  time.step_size = 3e-3;
  time.end_time  = 2.;
  EXPECT_EQ(time.n_steps(), 667u);
  time.end_time = 3e-3;
  EXPECT_EQ(time.n_steps(), 1u);
}

TEST(Reading, Bodies)
{
  const Scene<3> scene = read();
  ASSERT_EQ(scene.bodies.size(), 2u);
  const BodyDescription<3> &ball = scene.bodies[0];
  EXPECT_EQ(ball.name, "ball");
  EXPECT_EQ(ball.shape_name, "ball");
  EXPECT_DOUBLE_EQ(ball_of(ball).centre[2], 1.);
  EXPECT_EQ(ball.refinements, 2u);
  EXPECT_DOUBLE_EQ(ball.material.density, 2.);
  EXPECT_EQ(ball.initial_velocity[2], "-2*z");
  EXPECT_EQ(ball.initial_displacement[0], "0");

  const BodyDescription<3> &box = scene.bodies[1];
  EXPECT_DOUBLE_EQ(box_of(box).upper_corner[0], 3.);
  EXPECT_EQ(box_of(box).repetitions[2], 3u);
  EXPECT_EQ(box.body_force[2], "-9.81");
}

TEST(Reading, BoundaryConditions)
{
  const BodyDescription<3> box = read().bodies[1];
  ASSERT_EQ(box.dirichlet.size(), 2u);
  EXPECT_EQ(box.dirichlet[0].boundary_id, 0u);
  EXPECT_EQ(box.dirichlet[0].expressions[0], "0");
  EXPECT_EQ(box.dirichlet[0].expressions[1], "");
  EXPECT_EQ(box.dirichlet[1].expressions[2], "0.1*sin(pi*t)");
  ASSERT_EQ(box.traction.size(), 1u);
  EXPECT_EQ(box.traction[0].boundary_id, 5u);
  EXPECT_EQ(box.traction[0].expressions[2], "if(x > 2.5 || y > 0.5, -t, 0)");
}

TEST(Reading, WaveSpeed)
{
  Material material;
  material.youngs_modulus = 900.;
  EXPECT_DOUBLE_EQ(material.pressure_wave_speed(), 30.);
  material.poissons_ratio = .25;
  EXPECT_NEAR(material.pressure_wave_speed(), 30. * std::sqrt(1.2), 1e-12);
}

TEST(Reading, ObstaclesPairsProbes)
{
  const Scene<3> scene = read();
  ASSERT_EQ(scene.obstacles.size(), 2u);
  EXPECT_EQ(scene.obstacles[1].name, "pillar");
  EXPECT_NEAR(gap(scene, 0, {3., 4., 1.5}), 1.5, 1e-14);
  EXPECT_NEAR(gap(scene, 1, {2.5, 0.5, 1.}), 1.1, 1e-14);
  ASSERT_EQ(scene.pairs.size(), 2u);
  EXPECT_EQ(scene.pairs[0].name, "ball : floor");
  EXPECT_EQ(scene.pairs[0].slave, 0u);
  EXPECT_EQ(scene.pairs[0].obstacle, 0u);
  EXPECT_TRUE(scene.pairs[0].slave_boundary_ids.empty());
  EXPECT_EQ(scene.pairs[1].name, "box[2,4] : pillar");
  EXPECT_EQ(scene.pairs[1].slave_boundary_ids, (std::vector<dealii::types::boundary_id>{2, 4}));
  ASSERT_EQ(scene.probes.size(), 1u);
  EXPECT_EQ(scene.probes[0].name, "south");
  EXPECT_TRUE(scene.point_probes.empty());
}

TEST(Reading, AProbeOfABody)
{
  const Scene<3> scene = read({{"Probes/south/Body", "box"}});
  EXPECT_TRUE(scene.probes.empty());
  ASSERT_EQ(scene.point_probes.size(), 1u);
  EXPECT_EQ(scene.point_probes[0].name, "south");
  EXPECT_EQ(scene.bodies[scene.point_probes[0].body].name, "box");
}

// The text is read again, in another folder.
TEST(Reading, TheCopyHoldsWhatTheCommandLineSaid)
{
  const std::vector<Override> overrides = {{"Time/Step size", "1e-3"},
                                           {"Contact/ball : floor/Friction coefficient", "0.3"},
                                           {"Output directory", "output/other"}};
  const Scene<3>              scene     = read(overrides);
  EXPECT_EQ(scene.original_text.find(correct_scene()), 0u) << "first the file, comments and all";
  const TemporaryFile copy(scene.original_text);
  const Scene<3>      again = read_scene<3>(copy.name, {});
  EXPECT_EQ(again.all_parameters, scene.all_parameters);
  EXPECT_EQ(again.original_text, scene.original_text) << "nothing to be added";
  EXPECT_EQ(again.time.step_size, 1e-3);
  EXPECT_EQ(again.pairs[0].friction.coefficient, "0.3");
}

TEST(Reading, TheCopyFindsIncludedFiles)
{
  const TemporaryFile part(correct_scene());
  const TemporaryFile whole("  include " + std::filesystem::path(part.name).filename().string()
                            + "   # the rest\nset Mapping = curved\n");
  const Scene<3>      scene = read_scene<3>(whole.name, {});
  const std::string   path  = std::filesystem::absolute(part.name).string();
  EXPECT_EQ(scene.original_text, "include " + path + "\nset Mapping = curved\n");
}

TEST(Reading, Friction)
{
  const std::string pair = "Contact/ball : floor/";
  const auto        of   = [&](const std::vector<Override> &overrides) {
    return read(overrides).pairs[0].friction;
  };
  EXPECT_FALSE(read().pairs[1].friction.any);
  EXPECT_EQ(read().pairs[1].friction.law, FrictionKind::coulomb);

  const FrictionDescription coulomb =
    of({{pair + "Friction coefficient", "0.3 + 0.1*x"}, {pair + "Friction bound", "5"}});
  EXPECT_EQ(coulomb.law, FrictionKind::coulomb);
  EXPECT_EQ(coulomb.coefficient, "0.3 + 0.1*x");
  EXPECT_EQ(coulomb.bound, "5");
  EXPECT_TRUE(coulomb.any);
  EXPECT_EQ(of({{pair + "Friction coefficient", "0.3"}}).bound, "");

  const FrictionDescription tresca =
    of({{pair + "Friction law", "tresca"}, {pair + "Friction bound", "2 - z"}});
  EXPECT_EQ(tresca.law, FrictionKind::tresca);
  EXPECT_EQ(tresca.coefficient, "0");
  EXPECT_EQ(tresca.bound, "2 - z");
  EXPECT_TRUE(tresca.any);
}

// No friction is recognised however it is written, and then every scheme takes the pair.
TEST(Reading, NoFriction)
{
  const std::string pair = "Contact/ball : floor/";
  for (const std::string zero : {"0", "0.0", "1-1", "sin(0)", "-0"})
    {
      EXPECT_FALSE(read({{pair + "Friction coefficient", zero}, {"Time/Scheme", "moreau-jean"}})
                     .pairs[0]
                     .friction.any);
      EXPECT_FALSE(read({{pair + "Friction law", "tresca"},
                         {pair + "Friction bound", zero},
                         {"Time/Scheme", "moreau-jean"}})
                     .pairs[0]
                     .friction.any);
    }
  EXPECT_TRUE(read({{pair + "Friction coefficient", "x - x"}}).pairs[0].friction.any);
}

TEST(Reading, SchemesWithFriction)
{
  for (const std::string scheme : {"contact-stabilized",
                                   "contact-stabilized-projected",
                                   "contact-implicit",
                                   "laursen-chawla",
                                   "hager-hueeber-wohlmuth",
                                   "laursen-love",
                                   "newmark",
                                   "backward-euler"})
    EXPECT_TRUE(
      read({{"Contact/ball : floor/Friction coefficient", "0.3"}, {"Time/Scheme", scheme}})
        .pairs[0]
        .friction.any);
  EXPECT_TRUE(read({{"Contact/ball : floor/Friction coefficient", "0.3"},
                    {"Time/Scheme", "contact-stabilized"},
                    {"Time/Predictor mass", "lumped"}})
                .pairs[0]
                .friction.any);
}

TEST(Reading, StickingNodesAndStart)
{
  EXPECT_TRUE(read().time.parameters.stop_sticking_nodes);
  EXPECT_EQ(read().time.start, StartKind::given);
  EXPECT_FALSE(read({{"Time/Stop sticking nodes", "false"}}).time.parameters.stop_sticking_nodes);
  // All keys of a run are written, that of the displacement among them; the copy must be a scene,
  // too.
  const Scene<3> equilibrium =
    read({{"Time/Start", "equilibrium"}, {"Bodies/ball/Initial displacement", "0; 0.0; 1-1"}});
  EXPECT_EQ(equilibrium.time.start, StartKind::equilibrium);
  const TemporaryFile file(equilibrium.all_parameters);
  EXPECT_EQ(refusal(file.name), "");
}

TEST(Reading, Adaptivity)
{
  EXPECT_FALSE(read().adaptivity.any());

  const TemporaryFile file(
    correct_scene() + assignment("Adaptivity/Indicator", "kelly")
    + assignment("Adaptivity/Marking", "tolerance") + assignment("Adaptivity/Tolerance", "0.3")
    + assignment("Adaptivity/Maximum level", "5") + assignment("Adaptivity/Repetitions", "2"));
  const Scene<3> scene = read_scene<3>(file.name, {});
  EXPECT_TRUE(scene.adaptivity.any());
  EXPECT_EQ(scene.adaptivity.indicator, IndicatorKind::kelly);
  EXPECT_EQ(scene.adaptivity.marking, MarkingKind::tolerance);
  EXPECT_DOUBLE_EQ(scene.adaptivity.tolerance, 0.3);
  EXPECT_DOUBLE_EQ(scene.adaptivity.hysteresis, 0.1);
  EXPECT_EQ(scene.adaptivity.maximum_level, 5u);
  EXPECT_EQ(scene.adaptivity.minimum_level, 0u);
  EXPECT_EQ(scene.adaptivity.steps_between, 0u);
  EXPECT_EQ(scene.adaptivity.repetitions, 2u);
  const TemporaryFile all(scene.all_parameters); // lists all keys, those that have no effect, too
  EXPECT_EQ(read_scene<3>(all.name, {}).adaptivity.tolerance, 0.3);
}

TEST(Reading, OtherShapes)
{
  const Scene<3> scene = read({{"Bodies/ball/Shape", "cylinder"},
                               {"Bodies/ball/Axis", "x"},
                               {"Bodies/ball/Length", "3"},
                               {"Bodies/ball/Dirichlet", "2: 0; 0; 0"},
                               {"Obstacles/floor/Shape", "function"},
                               {"Obstacles/floor/Signed distance", "z - 0.1*x^2"},
                               {"Obstacles/pillar/Shape", "cylinder"},
                               {"Obstacles/pillar/Axis", "0, 2, 0"},
                               {"Obstacles/pillar/Bodies inside", "true"}});
  EXPECT_EQ(shape_of<CylinderShape>(scene.bodies[0]).axis, 0u);
  EXPECT_DOUBLE_EQ(shape_of<CylinderShape>(scene.bodies[0]).length, 3.);
  EXPECT_NEAR(gap(scene, 0, {1., 0., 0.3}), 0.2 / std::sqrt(1.04), 1e-9);
  EXPECT_NEAR(gap(scene, 1, {0.3, 7., 0.4}), 0.9 - 0.5, 1e-14);
}

TEST(Reading, TwoDimensions)
{
  const TemporaryFile file("set Dimension = 2\n" + assignment("Time/Step size", "1e-2")
                           + assignment("Time/End time", "1") + assignment("Bodies/Names", "disc")
                           + assignment("Bodies/disc/Centre", "0, 1")
                           + assignment("Bodies/disc/Initial velocity", "0; -2*y")
                           + assignment("Exact solution/Displacement", "0; -2*t")
                           + assignment("Exact solution/Velocity", "0; -2"));
  EXPECT_EQ(read_dimension(file.name, {}), 2u);
  const Scene<2> scene = read_scene<2>(file.name, {});
  EXPECT_DOUBLE_EQ(ball_of(scene.bodies[0]).centre[1], 1.);
  EXPECT_TRUE(scene.pairs.empty());
  EXPECT_TRUE(scene.exact_solution.given);
  EXPECT_EQ(scene.exact_solution.velocity[1], "-2");
}

TEST(Reading, OverridesComeLast)
{
  const Scene<3> scene = read({{"Time/Step size", "1e-2"},
                               {"Bodies/ball/Young's modulus", "700"},
                               {"Contact/box[2, 4]:pillar/Friction coefficient", "0"},
                               {"Time/Step size", "2e-2"}});
  EXPECT_DOUBLE_EQ(scene.time.step_size, 2e-2);
  EXPECT_DOUBLE_EQ(scene.bodies[0].material.youngs_modulus, 700.);
}

TEST(Reading, ContinuedLinesAndIncludedFiles)
{
  const TemporaryFile included(assignment("Time/Step size", "1e-2"));
  const std::string   name = included.name.substr(included.name.rfind('/') + 1);
  const ChangedScene  changed(
    correct_scene(), "include " + name + "\nsubsection Time\n  set End time \\\n = 1\nend\n");
  const Scene<3> scene = read_scene<3>(changed.file.name, {});
  EXPECT_DOUBLE_EQ(scene.time.step_size, 1e-2);
  EXPECT_DOUBLE_EQ(scene.time.end_time, 1.);
}

TEST(Reading, PrintedParametersAreAScene)
{
  std::ostringstream text;
  print_parameters(text);
  const TemporaryFile file(text.str());
  const Scene<3>      scene = read_scene<3>(file.name, {});
  EXPECT_EQ(scene.bodies.size() + scene.obstacles.size() + scene.pairs.size() + scene.probes.size(),
            4u);
}

TEST(Reading, AllParametersGiveTheSameScene)
{
  const Scene<3>      scene = read();
  const TemporaryFile file(scene.all_parameters);
  EXPECT_EQ(read_scene<3>(file.name, {}).all_parameters, scene.all_parameters);
}

// The scheme of the file looks at the key, that of the command line does not.
TEST(Reading, AllParametersGiveTheSameSceneWhateverTheCommandLineChose)
{
  const TemporaryFile scene_file(correct_scene() + assignment("Time/Scheme", "generalized-alpha")
                                 + assignment("Time/Spectral radius", "0.5"));
  const Scene<3>      scene = read_scene<3>(scene_file.name, {{"Time/Scheme", "backward-euler"}});
  const TemporaryFile file(scene.all_parameters);
  EXPECT_EQ(refusal(file.name), "");
  const Scene<3> again = read_scene<3>(file.name, {});
  EXPECT_EQ(again.all_parameters, scene.all_parameters);
  EXPECT_EQ(again.time.scheme, "backward-euler");
  EXPECT_EQ(read_scene<3>(scene_file.name, {}).all_parameters.find(beyond_the_file),
            std::string::npos);
}

TEST(Reading, ScenesOfTheProject)
{
  unsigned int n_scenes = 0;
  for (const auto &entry :
       std::filesystem::recursive_directory_iterator(SIGNORINI_SOURCE_DIR "/parameters"))
    if (entry.path().extension() == ".prm")
      {
        EXPECT_EQ(refusal(entry.path().string()), "");
        ++n_scenes;
      }
  EXPECT_GE(n_scenes, 6u);
}
