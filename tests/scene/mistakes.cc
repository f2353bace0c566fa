// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Every mistake is answered by a message that names the file, the line, the key, the value and a
// remedy.

#include "scene_file.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** A value that makes the correct scene wrong, and words that the message must contain. */
  struct Mistake
  {
    std::string              path;
    std::string              value;
    std::vector<std::string> words;
  };

  void expect_refusals(const std::vector<Mistake> &mistakes)
  {
    for (const Mistake &mistake : mistakes)
      {
        SCOPED_TRACE(mistake.path + " = " + mistake.value);
        const ChangedScene changed(correct_scene(), assignment(mistake.path, mistake.value));
        const std::string  message = refusal(changed.file.name);
        expect_words(message, {changed.file.name + ", line ", mistake.path, trim(mistake.value)});
        expect_words(message, mistake.words);

        const TemporaryFile correct(correct_scene());
        expect_words(refusal(correct.name, {{mistake.path, mistake.value}}),
                     {correct.name + ", --set", mistake.path});
      }
  }
} // namespace

TEST(Mistakes, TopLevelAndTime)
{
  expect_refusals(
    {{"Dimension", "4", {"2 (plane strain) or 3"}},
     {"Dimension", "three", {"must be"}},
     {"Output directory", "", {"is empty", "Name a folder"}},
     {"Mapping", "curvd", {"Did you mean `curved`?", "Valid: automatic, linear, curved"}},
     {"Time/Scheme", "contact-stabilised", {"Did you mean `contact-stabilized`?", "newmark"}},
     {"Time/Mass", "lumpd", {"Did you mean `lumped`?"}},
     {"Time/Step size", "0", {"must be positive"}},
     {"Time/Step size", "-1e-3", {"must be positive"}},
     {"Time/Step size", "nan", {"must be a finite number"}},
     {"Time/Step size", "fast", {"must be a finite number"}},
     {"Time/Step size", "1", {"larger than the end time 0.5", "Reduce"}},
     {"Time/Step size", "1e-12", {"hundred million", "Increase"}},
     {"Time/End time", "0", {"must be positive"}},
     {"Time/End time", "inf", {"must be a finite number"}},
     {"Time/Step size control", "doubled", {"Did you mean `doubling`?"}},
     {"Time/Step tolerance", "0.1", {"Step size control = fixed", "Remove"}},
     {"Time/Minimum step size", "1e-4", {"Step size control = fixed", "Remove"}},
     {"Time/Maximum step size", "1e-1", {"Step size control = fixed", "Remove"}}});
}

TEST(Mistakes, StepsOfVariableSize)
{
  const std::vector<Mistake> mistakes = {
    {"Time/Step tolerance", "0", {"between 1e-8 and 1"}},
    {"Time/Step tolerance", "nan", {"must be a finite number"}},
    {"Time/Minimum step size", "-1", {"must not be negative"}},
    {"Time/Minimum step size", "0.4", {"larger than the first `Step size`"}},
    {"Time/Maximum step size", "1e-9", {"smaller than the first `Step size`"}},
    {"Time/Scheme", "reference", {"Step size control", "another scheme"}}};
  for (const Mistake &mistake : mistakes)
    for (const std::string control : {"doubling", "embedded", "force"})
      {
        SCOPED_TRACE(mistake.path + " = " + mistake.value);
        const TemporaryFile correct(correct_scene());
        expect_words(refusal(correct.name,
                             {{"Time/Step size control", control}, {mistake.path, mistake.value}}),
                     mistake.words);
      }
}

TEST(Mistakes, StepsForATarget)
{
  const Override goal   = {"Time/Step size control", "goal"},
                 target = {"Adaptivity/Target error", "0.01"};
  const TemporaryFile correct(correct_scene());
  EXPECT_EQ(refusal(correct.name, {goal, target}), "") << "on a mesh that stays";
  expect_words(refusal(correct.name, {goal}),
               {"Step size control", "needs `Adaptivity/Target error`"});
  expect_words(refusal(correct.name, {goal, target, {"Time/Step tolerance", "0.1"}}),
               {"Step tolerance", "does not fit `Step size control = goal`", "Remove"});
  expect_words(refusal(correct.name, {goal, target, {"Time/Maximum step size", "1e-9"}}),
               {"smaller than the first `Step size`"});
}

// Beyond these limits a reader of expressions would run out of its stack, and end without a word.
TEST(Mistakes, ExpressionsWithoutEnd)
{
  const auto nested = [](const unsigned int n) {
    return "0; 0; " + std::string(n, '(') + "-1" + std::string(n, ')');
  };
  expect_refusals({{"Bodies/ball/Initial velocity", nested(101), {"more than 100 parentheses"}},
                   {"Bodies/ball/Initial velocity", nested(1000000), {"characters", "shorter"}},
                   {"Bodies/ball/Initial velocity",
                    "0; 0; " + std::string(20000, '-') + "1",
                    {"20001 characters", "at most 10000"}}});
  const TemporaryFile correct(correct_scene());
  EXPECT_EQ(refusal(correct.name, {{"Bodies/ball/Initial velocity", nested(100)}}), "");
}

TEST(Mistakes, ShapesAndMaterial)
{
  expect_refusals(
    {{"Bodies/ball/Shape", "bal", {"Did you mean `ball`?", "Valid: ball, box, cylinder"}},
     {"Bodies/ball/File", "ball.msh", {"is only for bodies from mesh files", "`Shape = ball`"}},
     {"Bodies/ball/Radius", "0", {"must be positive"}},
     {"Bodies/ball/Radius", "-1", {"must be positive"}},
     {"Bodies/ball/Radius", "9e-9", {"no mesh", "larger unit"}},
     {"Bodies/ball/Refine where", "0.2 - z", {"`Local refinements` does not say"}},
     {"Bodies/ball/Centre", "0, 1", {"must be 3 numbers", "commas"}},
     {"Bodies/ball/Centre", "0, 0, 1e-400", {"too small"}},
     {"Bodies/ball/Centre", "0; 0; 1", {"must be 3 numbers", "commas"}},
     {"Bodies/ball/Refinements", "-1", {"between 0 and 12"}},
     {"Bodies/ball/Refinements", "40", {"between 0 and 12"}},
     {"Bodies/ball/Refinements", "2.5", {"must be an integer"}},
     {"Bodies/ball/Local refinements", "2", {"`Refine where`"}},
     {"Bodies/ball/Refine where", "0.2 - q", {"cannot be understood", "x,y,z,h"}},
     {"Bodies/ball/Refine where", "1/h", {"infinite", "at h = 0"}},
     {"Bodies/box/Upper corner", "3, 0, 1.5", {"y coordinate", "Exchange"}},
     {"Bodies/box/Rotation", "90", {"must be 3 numbers", "commas"}},
     {"Bodies/box/Rotation centre", "1, 2", {"must be 3 numbers", "centre of the shape"}},
     {"Bodies/box/Rotation centre", "here", {"must be 3 numbers"}},
     {"Bodies/box/Translation", "0; 0; 1", {"must be 3 numbers", "commas"}},
     {"Bodies/box/Cap radius", "-2", {"must not be negative", "0 for a flat face"}},
     {"Bodies/ball/Cap radius", "2", {"is only for boxes", "`Shape = ball`"}},
     {"Bodies/ball/Cap boundary", "0", {"is only for boxes", "Remove"}},
     {"Bodies/box/Repetitions", "1, 0, 1", {"at least one cell in y"}},
     {"Bodies/box/Repetitions", "1, -2, 1", {"at least one cell in y"}},
     {"Bodies/ball/Young's modulus", "0", {"must be positive"}},
     {"Bodies/ball/Young's modulus", "-500", {"must be positive"}},
     {"Bodies/ball/Young's modulus", "1e-300", {"Choose other units"}},
     {"Bodies/ball/Density", "1e300", {"Choose other units"}},
     {"Bodies/ball/Poisson's ratio", "0.5", {"incompressible", "mixed method", "0.49"}},
     {"Bodies/ball/Poisson's ratio", "-1", {"shear modulus infinite", "larger"}},
     {"Bodies/ball/Poisson's ratio", "0.7", {"smaller than 0.5"}},
     {"Bodies/ball/Density", "0", {"must be positive"}}});
}

TEST(Mistakes, Expressions)
{
  expect_refusals(
    {{"Bodies/ball/Initial velocity", "0; 0; -2*q", {"`-2*q`", "Unexpected token \"q\"", "x,y,z"}},
     {"Bodies/ball/Initial velocity", "0; 0; sin(", {"`sin(`", "Unexpected end"}},
     {"Bodies/ball/Initial velocity", "0; 0; t", {"`t`", "x,y,z,"}},
     {"Bodies/ball/Initial velocity", "0; 0; ", {"Expression is empty"}},
     {"Bodies/ball/Initial velocity", "0, 0, -2", {"3 components", "semicolons"}},
     {"Bodies/ball/Initial velocity", "0; -2", {"3 components", "has 2"}},
     {"Bodies/ball/Initial displacement", "0; 0; 1/x", {"`1/x`", "infinite", "if(condition"}},
     {"Bodies/ball/Body force", "0; 0; sqrt(-1-t)", {"`sqrt(-1-t)`", "not a number", "t = 0"}},
     {"Bodies/box/Dirichlet", "0: foo(x); -; -", {"`foo(x)`", "cannot be understood"}},
     {"Bodies/box/Traction", "5: 0; 0; 1/(z - 1.5)", {"infinite"}}});
}

TEST(Mistakes, BoundaryConditions)
{
  expect_refusals(
    {{"Bodies/ball/Dirichlet", "1: 0; 0; 0", {"no boundary id `1`", "Valid: 0."}},
     {"Bodies/box/Dirichlet", "6: 0; 0; 0", {"no boundary id `6`", "Valid: 0, 1, 2, 3, 4, 5."}},
     {"Bodies/box/Dirichlet", "-1: 0; 0; 0", {"no boundary id `-1`"}},
     {"Bodies/box/Dirichlet", "0; 0; 0", {"boundary id", "Write"}},
     {"Bodies/box/Dirichlet", "0: 0; 0", {"3 components"}},
     {"Bodies/box/Dirichlet", "0: 0; -; - | 0: -; 0; -", {"given twice", "Join"}},
     {"Bodies/box/Traction", "1: 0; 0; 5", {"z component on boundary id 1", "Dirichlet"}}});
}

TEST(Mistakes, Names)
{
  expect_refusals({{"Bodies/Names", "", {"at least one body"}},
                   {"Bodies/Names", "ball,,box", {"empty name", "comma"}},
                   {"Bodies/Names", "ball, ball", {"given twice", "unique"}},
                   {"Bodies/Names", "ball, b/x", {"strange characters", "letters"}},
                   {"Bodies/Names", "ball box", {"strange characters"}},
                   {"Bodies/Names", std::string(100000, '-'), {"has 100000 characters", "at most"}},
                   {"Obstacles/Names", "floor, ball", {"name of a body"}}});
}

TEST(Mistakes, ObstaclesAndProbes)
{
  expect_refusals({{"Obstacles/floor/Shape", "plain", {"Did you mean `plane`?", "function"}},
                   {"Obstacles/floor/Normal", "0, 0, 0", {"zero vector"}},
                   {"Obstacles/floor/Normal", "0, 1", {"3 numbers"}},
                   {"Obstacles/pillar/Radius", "0", {"must be positive"}},
                   {"Probes/south/Point", "0, 0", {"3 numbers"}},
                   {"Probes/south/Body", "bal", {"no body `bal`", "Did you mean `ball`?"}}});
}

TEST(Mistakes, Pairs)
{
  expect_refusals(
    {{"Contact/Pairs",
      "bal : floor",
      {"no body `bal`", "Did you mean `ball`?", "Valid: ball, box"}},
     {"Contact/Pairs",
      "ball : flor",
      {"no obstacle or body `flor`", "Did you mean `floor`?", "pillar"}},
     {"Contact/Pairs", "ball : floor, ball : floor", {"same contact twice", "Remove"}},
     {"Contact/Pairs", "ball : floor, ball[0] : floor", {"same contact twice"}},
     {"Contact/Pairs", "ball : box, box : ball", {"same contact twice"}},
     {"Contact/Pairs", "ball : box[4], box[4,5] : ball[0]", {"same contact twice"}},
     {"Contact/Pairs", "ball : box[4,4]", {"names boundary id 4 twice"}},
     {"Contact/Pairs", "ball : bxo[4]", {"no obstacle or body `bxo`", "pillar, box"}},
     {"Contact/Pairs", "floor : ball", {"The body comes first"}},
     {"Contact/Pairs", "ball floor", {"is not a pair", "Write"}},
     {"Contact/Pairs", "ball[ : floor", {"is not a pair"}},
     {"Contact/Pairs", "ball[] : floor", {"is not a pair"}},
     {"Contact/Pairs", "ball[0,] : floor", {"is not a pair"}},
     {"Contact/Pairs", "ball[0 : floor", {"is not a pair"}},
     {"Contact/Pairs", "ball[0]] : floor", {"is not a pair"}},
     {"Contact/Pairs", "ball[1234567] : floor", {"is not a pair"}},
     {"Contact/Pairs", "ball : : floor", {"is not a pair"}},
     {"Contact/Pairs", "ball : " + std::string(100000, 'f'), {"no obstacle or body"}},
     {"Contact/Pairs", "ball[0] : floor[1]", {"no boundary ids"}}});
}

TEST(Mistakes, Friction)
{
  expect_refusals(
    {{"Contact/ball : floor/Friction law",
      "coulumb",
      {"Did you mean `coulomb`?", "Valid: coulomb, tresca"}},
     {"Contact/ball : floor/Friction law", "tresca,", {"Did you mean `tresca`?"}},
     {"Contact/ball : floor/Friction coefficient",
      "-0.3",
      {"must not be negative", "0 for no friction"}},
     {"Contact/ball : floor/Friction coefficient", "0.2 - 0.5", {"must not be negative"}},
     {"Contact/ball : floor/Friction coefficient", "1/0", {"must be a finite number", "Give"}},
     {"Contact/ball : floor/Friction coefficient", "inf", {"cannot be understood"}},
     {"Contact/ball : floor/Friction coefficient",
      "0.3*q",
      {"`0.3*q`", "cannot be understood", "x,y,z"}},
     {"Contact/ball : floor/Friction coefficient", "0.3*t", {"`0.3*t`", "cannot be understood"}},
     {"Contact/ball : floor/Friction coefficient", "1/(x - x)", {"infinite", "if(condition"}},
     {"Contact/ball : floor/Friction coefficient", "", {"Expression is empty"}},
     {"Contact/ball : floor/Friction bound", "0", {"no friction at all", "remove this key"}},
     {"Contact/ball : floor/Friction bound", "1 - 1", {"no friction at all"}},
     {"Contact/ball : floor/Friction bound", "-2", {"must not be negative", "positive stress"}},
     {"Contact/ball : floor/Friction bound", "2*", {"cannot be understood"}},
     {"Contact/box[2,4] : pillar/Friction bound",
      "2",
      {"`Friction coefficient`", "not given", "tresca"}}});
}

TEST(Mistakes, SolverAndOutput)
{
  expect_refusals({{"Solver/Preconditioner", "jacoby", {"Did you mean `jacobi`?"}},
                   {"Solver/Tolerance", "0", {"must be positive"}},
                   {"Solver/Tolerance", "-1", {"must be positive"}},
                   {"Solver/Tolerance", "1e-400", {"too small"}},
                   {"Solver/Maximum linear iterations", "99999999999", {"integer"}},
                   {"Solver/Tolerance", "0.1", {"at most 0.01"}},
                   {"Solver/Maximum linear iterations", "0", {"between 1 and"}},
                   {"Output/VTU", "perhaps", {"true or false"}},
                   {"Output/VTU every", "-1", {"between 0 and"}},
                   {"Output/History every", "0", {"between 1 and"}}});
}

TEST(Mistakes, Adaptivity)
{
  const std::string adaptive =
    assignment("Adaptivity/Indicator", "residual") + assignment("Adaptivity/Maximum level", "4");
  const auto expect = [&](const std::string              &key,
                          const std::string              &value,
                          const std::vector<std::string> &words,
                          const std::string              &more = "") {
    const std::string path = "Adaptivity/" + key;
    SCOPED_TRACE(path + " = " + value);
    const ChangedScene changed(correct_scene() + adaptive, more + assignment(path, value));
    const std::string  message = refusal(changed.file.name);
    expect_words(message, {changed.file.name + ", line ", path, value});
    expect_words(message, words);
  };
  EXPECT_EQ(refusal(TemporaryFile(correct_scene() + adaptive).name), "");
  EXPECT_EQ(
    refusal(TemporaryFile(correct_scene() + adaptive).name, {{"Adaptivity/Indicator", "none"}}),
    "");
  expect("Indicator", "kely", {"Did you mean `kelly`?", "none, residual"});
  expect("Marking", "fixed", {"Valid: fixed fraction, tolerance"});
  expect("Refine fraction", "1.5", {"between 0 and 1"});
  expect("Coarsen fraction", "0.6", {"between 0 and 0.5", "undo"});
  expect("Coarsen ratio", "1.5", {"between 0 and", "threshold of refinement"});
  expect("Hysteresis", "-0.1", {"between 0 and 0.5"});
  expect("Tolerance", "-1", {"must not be negative"});
  expect("Maximum level", "0", {"nothing to refine", "Bodies/box/Refinements"});
  expect("Maximum level", "99", {"between 0 and 15"});
  expect("Minimum level", "4", {"smaller than `Maximum level` = 4"});
  expect("Steps between remeshings", "-1", {"between 0 and"});
  expect("Repetitions", "100", {"between 0 and 20"});
  expect(
    "Distance", "-0.1", {"must not be negative"}, assignment("Adaptivity/Indicator", "distance"));
  expect("Tolerance",
         "0.1",
         {"Indicator = distance", "Remove"},
         assignment("Adaptivity/Indicator", "distance"));
  expect("Marking",
         "tolerance",
         {"Indicator = distance", "Remove"},
         assignment("Adaptivity/Indicator", "distance"));
  expect("Refine fraction",
         "0.3",
         {"Marking = tolerance", "Remove"},
         assignment("Adaptivity/Marking", "tolerance") + assignment("Adaptivity/Tolerance", "1"));
  expect("Indicator",
         "kelly",
         {"Mass = redistributed", "acceleration", "`Mass = consistent`"},
         assignment("Time/Scheme", "khenous-laborde-renard"));
}

TEST(Mistakes, TheEqualShareNeedsATolerance)
{
  const TemporaryFile file(correct_scene() + assignment("Adaptivity/Indicator", "kelly")
                           + assignment("Adaptivity/Maximum level", "4")
                           + assignment("Adaptivity/Marking", "tolerance"));
  expect_words(refusal(file.name),
               {file.name, "Adaptivity/Tolerance", "is missing", "Marking = tolerance"});
}

TEST(Mistakes, UnknownKeysAndSections)
{
  expect_refusals(
    {{"Dimensions", "3", {"unknown key", "Did you mean `Dimension`?", "Valid:"}},
     {"Bodies/ball/Center", "0, 0, 1", {"Did you mean `Centre`?"}},
     {"Bodies/ball/Youngs modulus", "1", {"Did you mean `Young's modulus`?", "Density"}},
     {"Step size", "1e-3", {"belongs to section `Time`", "end"}},
     {"Bodies/ball/Files", "x.msh", {"Did you mean `File`?"}}});
  const auto expect = [](const std::string &path, const std::vector<std::string> &words) {
    const TemporaryFile file(correct_scene() + assignment(path, "1"));
    expect_words(refusal(file.name), {file.name + ", line "});
    expect_words(refusal(file.name), words);
  };
  expect("Tim/Step size", {"unknown section `Tim`", "Did you mean `Time`?", "Valid: Time, Bodies"});
  expect("Bodies/bal/Radius",
         {"unknown section `Bodies/bal`", "`Bodies/Names`", "Did you mean `ball`?"});
  expect("Contact/ball : pillar/Friction coefficient",
         {"`Contact/Pairs` does not list this pair", "add"});
  expect("Time/Scheme/Name", {"unknown section `Time/Scheme`", "no sections inside", "`end`"});
  expect("Kinematics", {"not available in this version", "Remove"});
}

TEST(Mistakes, FrictionThatDoesNotFit)
{
  const auto expect = [](const std::vector<Override>    &overrides,
                         const std::vector<std::string> &words) {
    const TemporaryFile file(correct_scene());
    expect_words(refusal(file.name, overrides), words);
  };
  const std::string pair = "Contact/ball : floor/";
  expect({{pair + "Friction law", "tresca"}},
         {"Friction bound (not given)", "tresca` needs", "coulomb"});
  expect({{pair + "Friction law", "tresca"}, {pair + "Friction bound", "-1"}},
         {"Friction bound = -1", "negative"});
  for (const std::string coefficient : {"0.3", "0.1*x"})
    expect({{pair + "Friction law", "tresca"},
            {pair + "Friction bound", "2"},
            {pair + "Friction coefficient", coefficient}},
           {"Friction coefficient = " + coefficient, "not used", "Remove", "coulomb"});
  for (const std::string scheme : {"khenous-laborde-renard",
                                   "hht-alpha",
                                   "generalized-alpha",
                                   "nonsmooth-generalized-alpha",
                                   "moreau-jean",
                                   "reference"})
    {
      expect({{"Time/Scheme", scheme}, {pair + "Friction coefficient", "0.3"}},
             {"Friction coefficient = 0.3",
              scheme + " knows no friction",
              "contact-implicit, laursen-chawla"});
      expect({{"Time/Scheme", scheme},
              {pair + "Friction law", "tresca"},
              {pair + "Friction bound", "x"}},
             {"Friction bound = x", scheme + " knows no friction", "`Friction bound = 0`"});
    }
}
