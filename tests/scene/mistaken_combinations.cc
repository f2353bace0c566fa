// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Values that are right each for itself, but not together, are answered by a message that names one
// of them, the other, and a remedy.

#include "scene_file.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  void expect(const std::vector<Override> &overrides, const std::vector<std::string> &words)
  {
    const TemporaryFile file(correct_scene());
    expect_words(refusal(file.name, overrides), words);
  }
} // namespace

TEST(Combinations, OfDampingAndStepSize)
{
  expect({{"Bodies/ball/Damping", "0, 1e6"}}, {"Damping = 0, 1e6", "Step size", "Dirichlet"});
  expect({{"Bodies/ball/Damping", "1e9, 0"}}, {"Damping = 1e9, 0", "Step size", "Dirichlet"});
}

TEST(Combinations, OfSolverAndFriction)
{
  expect({{"Solver/Inequality", "truncated-newton-multigrid"},
          {"Contact/ball : floor/Friction coefficient", "0.3"}},
         {"Inequality = truncated-newton-multigrid", "no friction", "Remove"});
}

TEST(Combinations, OfSchemesAndContactThatFollows)
{
  const std::vector<std::pair<std::string, std::string>> refused = {
    {"newmark", "forces of the last step"},
    {"generalized-alpha", "forces of the last step"},
    {"moreau-jean", "drift"},
    {"khenous-laborde-renard", "forces of the last step"}};
  for (const auto &[scheme, reason] : refused)
    expect({{"Contact/Motion", "follow"},
            {"Time/Scheme", scheme},
            {"Obstacles/floor/Shape", "sphere"},
            {"Obstacles/floor/Centre", "0, 0, -5"}},
           {"Motion = follow", scheme, reason, "contact-implicit", "linearised"});
  expect({{"Contact/Motion", "linearised"},
          {"Contact/Pairs", "ball : floor, box[2,4] : pillar, ball : ball"}},
         {"Motion = linearised", "with itself", "`ball : ball`", "follow", "remove the pair"});
  expect({{"Contact/Motion", "follow"}, {"Time/Scheme", "moreau-jean"}}, // the floor is flat
         {"Motion = follow", "how deep"});
  expect({{"Obstacles/floor/Velocity", "0; 0; -1"}, {"Time/Scheme", "newmark"}},
         {"'floor' moves", "cannot follow with Time/Scheme = newmark", "contact-implicit"});
  expect({{"Obstacles/floor/Velocity", "0; 0; -1"},
          {"Time/Scheme", "contact-implicit"},
          {"Time/Mass", "redistributed"}},
         {"'floor' moves", "Set `Motion = follow`"});
}

TEST(Combinations, ThatContactFollowsByDefault)
{
  const auto decided = [](const std::vector<Override> &overrides) {
    const TemporaryFile file(correct_scene());
    const Scene<3>      scene = read_scene<3>(file.name, overrides);
    EXPECT_EQ(scene.motion == ContactMotion::follow, scene.why_linearised.empty());
    return scene.why_linearised;
  };
  EXPECT_EQ(decided({}), "");
  expect_words(decided({{"Time/Scheme", "moreau-jean"}}), {"cannot", "moreau-jean", "how deep"});
  expect_words(decided({{"Time/Scheme", "contact-implicit"}, {"Time/Mass", "redistributed"}}),
               {"contact nodes without mass", "`Motion = follow` asks for it"});
}

// Messages of contact name what lets it follow: the key where the scheme follows, and where it does
// not, schemes that do and that know the rest of the scene, too.
TEST(Combinations, WhatLetsContactFollow)
{
  const auto remedy = [](const std::vector<Override> &overrides) {
    const TemporaryFile file(correct_scene());
    return read_scene<3>(file.name, overrides).how_to_follow;
  };
  const std::string the_key = "set `Contact/Motion = follow`";
  EXPECT_EQ(remedy({{"Contact/Motion", "linearised"}}), the_key);
  EXPECT_EQ(remedy({{"Time/Scheme", "contact-implicit"}, {"Time/Mass", "redistributed"}}), the_key);
  for (const std::string motion : {"automatic", "linearised"})
    {
      const std::string text = remedy({{"Contact/Motion", motion}, {"Time/Scheme", "moreau-jean"}});
      expect_words(text, {"contact-stabilized-projected", "laursen-love", "moreau-jean cannot"});
      for (const char *wrong : {"newmark", "nonsmooth", "static", "reference", "hager"})
        EXPECT_EQ(text.find(wrong), std::string::npos) << wrong << ": " << text;
    }
}

TEST(Combinations, OfSchemes)
{
  expect({{"Time/Scheme", "newmark"}, {"Time/Predictor mass", "lumped"}},
         {"Predictor mass = lumped", "Scheme = newmark", "Remove"});
  expect({{"Time/Scheme", "contact-stabilized-projected"}, {"Time/Predictor mass", "lumped"}},
         {"Predictor mass = lumped", "Mass = lumped", "or take contact-stabilized."});
  expect({{"Time/Mass", "redistributed"}}, // the scheme is contact-stabilized
         {"Mass = redistributed",
          "makes no sense with Scheme = contact-stabilized",
          "predictor",
          "contact-implicit"});
  expect(
    {{"Time/Mass", "zero on contact boundary"}, {"Time/Scheme", "contact-stabilized-projected"}},
    {"makes no sense", "predictor"});
  expect({{"Time/Mass", "redistributed"}, {"Time/Scheme", "laursen-love"}},
         {"makes no sense", "impulses"});
  expect({{"Time/Mass", "redistributed"}, {"Time/Scheme", "hht-alpha"}},
         {"makes no sense", "accelerations"});
  expect({{"Time/Mass", "lumped"}, {"Time/Scheme", "khenous-laborde-renard"}},
         {"Mass = lumped", "contact nodes without mass", "Remove"});
  expect({{"Time/Mass redistribution", "minimisation"}, {"Time/Scheme", "newmark"}},
         {"Mass redistribution = minimisation", "Mass = consistent", "redistributed"});
  expect({{"Time/Newmark beta", "0.2"}},
         {"Newmark beta = 0.2", "between 0.25 and 1", "not stable"});
  expect({{"Time/Newmark gamma", "1.2"}}, {"Newmark gamma = 1.2", "Newmark beta", "not stable"});
  expect({{"Time/Reference tolerance", "0"}}, {"Reference tolerance = 0", "between"});
  expect({{"Time/Scheme", "newmark"}, {"Time/Impulses", "common"}},
         {"Impulses = common", "Scheme = newmark", "Remove"});
  expect({{"Time/Scheme", "newmark"}, {"Time/Stop sticking nodes", "false"}},
         {"Stop sticking nodes = false", "Scheme = newmark", "Remove"});
}

TEST(Combinations, OfKeysAndShapesOrSchemesThatDoNotLookAtThem)
{
  expect({{"Time/HHT alpha", "-0.2"}},
         {"HHT alpha = -0.2: is only for hht-alpha",
          "no effect with `Scheme = contact-stabilized-projected`",
          "Remove"});
  expect({{"Time/Newmark beta", "0.3"}}, {"Newmark beta = 0.3: is only for khenous-"});
  expect({{"Obstacles/floor/Radius", "2"}},
         {"Obstacles/floor/Radius = 2: is only for the shape sphere or cylinder",
          "`Shape = plane`",
          "Remove"});
  expect({{"Obstacles/floor/Signed distance", "z"}}, {"is only for the shape function"});
  expect({{"Obstacles/pillar/Point", "1, 0, 0"}}, {"is only for the shape plane or cylinder"});
  expect({{"Obstacles/pillar/Extent", "1, 1"}}, {"is only for the shape plane"});
  expect({{"Bodies/ball/Upper corner", "2, 2, 2"}},
         {"Upper corner = 2, 2, 2: is only for boxes", "`Shape = ball`"});
  expect({{"Bodies/box/Length", "3"}}, {"is only for cylinders", "`Shape = box`"});
  // A list of all keys with their defaults is a scene, too.
  const TemporaryFile file(correct_scene());
  EXPECT_EQ(
    refusal(
      file.name,
      {{"Time/HHT alpha", "-0.1"}, {"Obstacles/floor/Radius", "1"}, {"Bodies/box/Radius", "1"}}),
    "");
}

TEST(Combinations, OfInertiaAndSchemesWithoutIt)
{
  const Override without = {"Time/Scheme", "static"},
                 at_rest = {"Bodies/ball/Initial velocity", "0; 0; 0"};
  expect({without},
         {"Bodies/ball/Initial velocity = 0; 0; -2*z", "static", "no inertia", "Remove"});
  expect({without, at_rest, {"Bodies/ball/Damping", "0, 1e-3"}},
         {"Bodies/ball/Damping = 0, 1e-3", "Time/Scheme = static", "backward-euler"});
  for (const std::string mass : {"lumped", "redistributed", "zero on contact boundary"})
    expect({without, at_rest, {"Time/Mass", mass}},
           {"Time/Mass = " + mass, "static, which moves no mass"});
  for (const std::string control : {"doubling", "embedded", "force", "goal"})
    expect({without, at_rest, {"Time/Step size control", control}},
           {"Step size control = " + control, "load steps have none", "Remove"});
  const TemporaryFile file(correct_scene());
  EXPECT_EQ(refusal(file.name, {without, at_rest}), "");
}

TEST(Combinations, OfStepsByForceAndNoContact)
{
  const std::string   all = correct_scene();
  const TemporaryFile file(all.substr(0, all.find("subsection Contact")));
  const std::string   message = refusal(file.name, {{"Time/Step size control", "force"}});
  for (const std::string word : {"Step size control = force", "nothing that touches", "doubling"})
    EXPECT_NE(message.find(word), std::string::npos) << message;
  EXPECT_EQ(refusal(file.name, {{"Time/Step size control", "doubling"}}), "");
}

TEST(Combinations, OfExtents)
{
  for (const std::string value : {"1", "1, 2, 3", "1, -2", "1, x", "0, 1"})
    expect({{"Obstacles/floor/Extent", value}}, {"Extent = " + value, "two lengths > 0"});
  expect({{"Obstacles/floor/Extent", "1, 2"}, {"Obstacles/floor/Extent direction", "0, 0, 3"}},
         {"Extent direction = 0, 0, 3", "direction of `Normal`"});
  expect({{"Obstacles/floor/Extent direction", "0, 1, 0"}}, {"no effect without `Extent`"});
}

TEST(Combinations, OfMovingConditions)
{
  expect({{"Time/Scheme", "reference"}, {"Bodies/box/Dirichlet", "0: 0; -; sin(t)"}},
         {"Bodies/box/Dirichlet = 0: 0; -; sin(t)", "Scheme = reference", "Take another scheme"});
}

TEST(Combinations, OfOtherValues)
{
  expect({{"Time/Start", "equilibrium"}, {"Bodies/box/Initial displacement", "0; 0; 0.1*x"}},
         {"Bodies/box/Initial displacement = 0; 0; 0.1*x", "Time/Start = equilibrium", "Remove"});
  expect({{"Contact/Pairs", ""}}, {"unknown section `Contact/ball : floor`"});
  expect({{"Bodies/Names", "ball, box, cube"}}, {"Bodies/cube", "no subsection", "Add"});
  expect({{"Obstacles/Names", "floor, pillar, wall"}}, {"Obstacles/wall", "no subsection", "Add"});
  expect({{"Probes/Names", "south, north"}}, {"Probes/north/Point (not given)", "Add"});
  expect({{"Bodies/ball/Shape", "cylinder"}, {"Bodies/ball/Length", "-1"}},
         {"Length = -1", "positive"});
  expect({{"Bodies/ball/Shape", "file"}}, {"Bodies/ball/File (not given)", "needs a mesh"});
  expect({{"Bodies/box/Cap radius", "2"}}, {"Cap boundary (not given)", "0, 1, 2, 3, 4, 5"});
  expect({{"Bodies/box/Cap radius", "2"}, {"Bodies/box/Cap boundary", "6"}},
         {"Cap boundary = 6", "0, 1, 2, 3, 4, 5"});
  // The face has edges of length 1, the opposite face is at distance 1: half of the diagonal
  // counts.
  expect({{"Bodies/box/Cap radius", "0.7071"}, {"Bodies/box/Cap boundary", "4"}},
         {"Cap radius = 0.7071", "does not fit", "larger than 0.707107"});
  // At distance 0.5 only, it would reach the opposite face: (0.5 + 0.25) / (2 * 0.5).
  expect({{"Bodies/box/Cap radius", "0.74"},
          {"Bodies/box/Cap boundary", "4"},
          {"Bodies/box/Upper corner", "3, 1, 1"}},
         {"Cap radius = 0.74", "larger than 0.75", "opposite face"});
  expect({{"Obstacles/floor/Shape", "function"}},
         {"Obstacles/floor/Signed distance (not given)", "Give one"});
  expect({{"Obstacles/floor/Shape", "function"}, {"Obstacles/floor/Signed distance", "z - rand()"}},
         {"Signed distance = z - rand()", "the function `rand` has no derivative", "Write it"});
  expect({{"Exact solution/Displacement", "0; 0; 1"}},
         {"Exact solution/Velocity (not given)", "both"});
  expect({{"Exact solution/Velocity", "0; 0; 1"}},
         {"Exact solution/Displacement (not given)", "both"});
}

TEST(Combinations, OfMeshesAndTheirGoal)
{
  const std::string adaptive =
    assignment("Adaptivity/Indicator", "residual") + assignment("Adaptivity/Goal", "contact force")
    + assignment("Adaptivity/Target error", "0.01") + assignment("Adaptivity/Maximum level", "4");
  EXPECT_EQ(refusal(TemporaryFile(correct_scene() + adaptive).name), "");
  const auto expect =
    [&](const std::string &key, const std::string &value, const std::vector<std::string> &words) {
      const std::string path = "Adaptivity/" + key;
      SCOPED_TRACE(path + " = " + value);
      const ChangedScene changed(correct_scene() + adaptive, assignment(path, value));
      const std::string  message = refusal(changed.file.name);
      expect_words(message, {changed.file.name + ", line ", path, value});
      expect_words(message, words);
    };
  expect("Goal", "force", {"Valid: energy, contact force, contact pressure, probe"});
  expect("Target error", "0", {"is missing", "Give for example"});
  expect("Target error", "1.5", {"between 0 and 1"});
  expect("Target error", "-0.1", {"between 0 and 1"});
  expect("Maximum level", "0", {"begins with", "a larger one"});
  const std::string of_energy = "belongs to `Goal = energy`";
  expect("Marking", "tolerance", {of_energy, "Remove"});
  expect("Refine fraction", "0.3", {of_energy, "Remove"});
  expect("Tolerance", "1", {of_energy, "Remove"});
  const auto refusal_with = [&](const std::string &path, const std::string &value) {
    const ChangedScene changed(correct_scene() + adaptive, assignment("Adaptivity/" + path, value));
    return refusal(changed.file.name);
  };
  expect_words(refusal_with("Indicator", "kelly"), {"Goal", "needs", "Indicator = residual"});
  expect_words(refusal_with("Indicator", "distance"), {"Goal", "Indicator = distance", "Remove"});
  expect_words(refusal_with("Goal", "energy"), {"Target error", "Goal = contact force"});
  EXPECT_EQ(refusal_with("Goal", "contact pressure"), "");
  EXPECT_EQ(refusal_with("Goal", "probe"), "");
  // Who forgets the indicator is told so; who says that the mesh stays may keep the other keys.
  EXPECT_EQ(refusal_with("Indicator", "none"), "");
  const TemporaryFile forgotten(correct_scene() + assignment("Adaptivity/Goal", "contact force")
                                + assignment("Adaptivity/Target error", "0.01"));
  expect_words(refusal(forgotten.name),
               {forgotten.name + ", line ", "Goal = contact force", "Indicator = residual"});
  EXPECT_EQ(refusal(TemporaryFile(correct_scene() + assignment("Adaptivity/Target error", "0.01")
                                  + assignment("Adaptivity/Maximum level", "0"))
                      .name),
            "");
  const std::string  scene = correct_scene();
  const ChangedScene no_probes(scene.substr(0, scene.find("subsection Probes")) + adaptive,
                               assignment("Adaptivity/Goal", "probe"));
  expect_words(refusal(no_probes.file.name), {"Goal", "the scene has none", "Probes/Names"});
}
