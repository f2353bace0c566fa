// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A mesh file on which nothing can be computed is refused with one clear sentence, and nothing
// crashes.

#include "scene_file.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  std::string read_file(const std::string &name)
  {
    std::ostringstream text;
    text << std::ifstream(SIGNORINI_SOURCE_DIR "/parameters/meshes/" + name).rdbuf();
    return text.str();
  }

  std::string replaced(std::string text, const std::string &old_words, const std::string &new_words)
  {
    const std::size_t position = text.find(old_words);
    EXPECT_NE(position, std::string::npos) << old_words;
    return position == std::string::npos ? text
                                         : text.replace(position, old_words.size(), new_words);
  }

  std::string scene_with(const std::string &mesh_file, const unsigned int dim)
  {
    return "set Dimension = " + std::to_string(dim) + "\n" + assignment("Time/Step size", "1e-2")
           + assignment("Time/End time", "1") + assignment("Bodies/Names", "body")
           + assignment("Bodies/body/Shape", "file") + assignment("Bodies/body/File", mesh_file);
  }

  std::string
  message_about(const std::string &mesh, const std::string &extension, const unsigned int dim)
  {
    const TemporaryFile file(mesh, extension);
    const TemporaryFile scene(scene_with(file.name, dim));
    const std::string   message = refusal(scene.name);
    if (!message.empty())
      expect_words(message, {scene.name + ", line ", "Bodies/body/File = " + file.name});
    return message;
  }

  struct MeshMistake
  {
    std::string              mesh, extension;
    unsigned int             dim;
    std::vector<std::string> words;
  };

  void expect_mesh_refusals(const std::vector<MeshMistake> &mistakes)
  {
    for (const MeshMistake &mistake : mistakes)
      {
        SCOPED_TRACE(mistake.extension + " in " + std::to_string(mistake.dim) + "d:\n"
                     + mistake.mesh.substr(0, 600));
        expect_words(message_about(mistake.mesh, mistake.extension, mistake.dim), mistake.words);
      }
  }

  void expect_two_squares(const std::string &mesh, const std::string &extension)
  {
    const TemporaryFile file(mesh, extension);
    const TemporaryFile scene(scene_with(file.name, 2));
    EXPECT_EQ(refusal(scene.name), "") << mesh;
    // The edge below the first square is the only one with a boundary id; VTK has none.
    const auto body = read_scene<2>(scene.name, {}).bodies[0];
    EXPECT_EQ(mesh_of(body).boundary_vertices.count(7), extension == ".vtk" ? 0u : 1u) << mesh;
    EXPECT_EQ(mesh_of(body).boundary_vertices.at(0).size(), 6u) << mesh;
  }

  // Two squares side by side, in all formats.
  const std::string ucd = "6 3 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n6 2 1 0\n1 0 "
                          "quad 1 2 3 4\n2 0 quad 2 5 6 3\n3 7 line 1 2\n";
  const std::string vtk =
    "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n0 0 0\n1 "
    "0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\nCELLS 2 10\n4 0 1 2 3\n4 1 4 5 2\nCELL_TYPES 2\n9\n9\n";
  const std::string msh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n"
    "6 2 1 0\n$EndNodes\n$Elements\n3\n1 1 2 7 7 1 2\n2 3 2 1 1 1 2 3 4\n3 3 2 1 1 2 5 6 3\n"
    "$EndElements\n";
  const std::string msh_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 1 1 0\n1 0 0 0 1 0 "
                            "0 1 7 0\n1 0 0 0 2 1 0 1 1 0\n$EndEntities\n$Nodes\n1 6 1 6\n2 1 0 6\n"
                            "1\n2\n3\n4\n5\n6\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n"
                            "$EndNodes\n$Elements\n2 3 1 3\n1 1 1 1\n1 1 2\n2 1 3 2\n2 1 2 3 4\n3 "
                            "2 5 6 3\n$EndElements\n";
  const std::string inp   = "*Heading\n squares\n*Node\n1, 0., 0.\n2, 1., 0.\n** a comment\n3, 1., "
                            "1.\n4, 0., 1.\n5, 2., 0.\n6, 2., 1.\n*Element, type=CPE4\n11, 1, 2, "
                            "3, 4\n12, 2, 5, 6, 3\n*Surface, name=Surf-7\n11, S1\n*Step\n*Node "
                            "print\nU\n";
} // namespace

TEST(MistakesInMeshes, CorrectMeshesAreRead)
{
  const std::vector<std::pair<std::string, std::string>> meshes = {
    {ucd, ".ucd"},
    {ucd, ".inp"},
    {vtk, ".vtk"},
    {msh, ".msh"},
    {msh_4, ".msh"},
    {inp, ".inp"},
    {inp, ".INP"},
    // In Gmsh files, cells are turned around that only list their vertices in the wrong direction.
    {replaced(msh, "2 5 6 3", "3 6 5 2"), ".msh"}};
  for (const auto &[mesh, extension] : meshes)
    expect_two_squares(mesh, extension);
}

TEST(MistakesInMeshes, Files)
{
  const TemporaryFile scene(scene_with("missing.msh", 2));
  expect_words(refusal(scene.name),
               {"Bodies/body/File = missing.msh", "no such file", "folder of the scene"});
  const TemporaryFile folder(scene_with("../", 2));
  expect_words(refusal(folder.name), {"the extension `` is not known", ".msh"});
  expect_mesh_refusals(
    {{ucd, ".stl", 2, {"the extension `.stl` is not known", "Valid: .msh (Gmsh)"}},
     {"", ".msh", 2, {"is empty"}},
     {std::string("*NODE\n\0", 7), ".inp", 2, {"binary", "ASCII"}},
     {"hello", ".msh", 2, {"not a Gmsh mesh"}},
     {"hello", ".vtk", 2, {"not a VTK file"}},
     {"hello", ".ucd", 2, {"broken", "the first line"}},
     {"* hello", ".inp", 2, {"no mesh", "`*NODE`"}}});
}

// Counts that the file cannot keep are refused before memory or time are spent on them.
TEST(MistakesInMeshes, CountsBeyondTheFile)
{
  const std::string squares = inp.substr(0, inp.find("*Surface"));
  expect_mesh_refusals(
    {{replaced(msh_4, "$Entities\n0", "$Entities\n99999999999"), ".msh", 2, {"`$Entities`"}},
     {replaced(msh_4, "1 7 0\n", "99999999999 7 0\n"), ".msh", 2, {"`$Entities`"}},
     {replaced(msh_4, "1 1 1 1\n1 1 2", "4 1 1 1\n1 1 2"), ".msh", 2, {"in 4 dimensions"}},
     {replaced(msh_4, "1 1 1 1\n1 1 2", "-1 1 1 1\n1 1 2"), ".msh", 2, {"in -1 dimensions"}},
     {"$NOD\n4000000000\n1 0 0 0\n$ENDNOD\n$ELM\n0\n$ENDELM\n", ".msh", 2, {"`$NOD`"}},
     {squares + "*Elset, elset=all, generate\n1, 999999999999\n",
      ".inp",
      2,
      {"element set `ALL`", "from 1 to 999999999999", "more elements"}}});
}

// A set may be given in parts, name others, and even itself; each element is in it once.
TEST(MistakesInMeshes, SetsThatNameThemselves)
{
  std::string mesh = replaced(inp, "11, S1", "ALL, S1");
  for (unsigned int doubling = 0; doubling < 60; ++doubling)
    mesh = replaced(mesh, "*Surface", "*Elset, elset=all\n11, all, all\n*Surface");
  expect_two_squares(mesh, ".inp");
}

TEST(MistakesInMeshes, Dimension)
{
  const std::vector<std::string> flat = {
    "it is a mesh in 2d", "`Dimension = 3`", "change the dimension"};
  expect_mesh_refusals(
    {{ucd, ".ucd", 3, flat},
     {vtk, ".vtk", 3, flat},
     {msh, ".msh", 3, flat},
     {msh_4, ".msh", 3, flat},
     {inp, ".inp", 3, flat},
     {read_file("anvil.msh"), ".msh", 2, {"it is a mesh in 3d", "`Dimension = 2`"}},
     {read_file("hammer.inp"), ".inp", 2, {"it is a mesh in 3d", "`Dimension = 2`"}}});
}

TEST(MistakesInMeshes, Cells)
{
  const std::string pyramid =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
    "5 0 0 1\n$EndNodes\n$Elements\n1\n9 7 2 1 1 1 2 3 4 5\n$EndElements\n";
  expect_mesh_refusals(
    {{pyramid, ".msh", 3, {"cell 9 is a pyramid", "tetrahedra"}},
     {replaced(msh, "3 3 2 1 1 2 5 6 3", "3 21 2 1 1 2 5 6 3 1 2 3 4 5 6"),
      ".msh",
      2,
      {"Gmsh's type 21", "ElementOrder"}},
     {replaced(msh, "3\n1 1 2 7 7 1 2\n2 3 2 1 1 1 2 3 4\n3 3 2 1 1 2 5 6 3\n", "0\n"),
      ".msh",
      2,
      {"any cells"}},
     {replaced(ucd, "quad 2 5 6 3", "cube 2 5 6 3"), ".ucd", 2, {"cell 2 has the type `cube`"}},
     {"2 1 0 0 0\n1 0 0 0\n2 1 0 0\n1 0 line 1 2\n", ".ucd", 2, {"no quadrilaterals"}},
     {replaced(inp, "CPE4", "CPE3"), ".inp", 2, {"element 11 has more than 3 vertices"}},
     {replaced(inp, "CPE4", "CPE5"), ".inp", 2, {"type `CPE5`", "Only triangles"}},
     {replaced(inp, "CPE4", "CPE4!"), ".inp", 2, {"type `CPE4!`", "Only triangles"}},
     {replaced(inp, "CPE4", "C3D8" + std::string(100000, 'A')), ".inp", 2, {"type `C3D8AAA"}},
     {replaced(read_file("hammer.inp"), "C3D8", "C3D4"),
      ".inp",
      3,
      {"element 1 has more than 4 vertices"}},
     {replaced(read_file("hammer.inp"), "C3D8", "C3D20"), ".inp", 3, {"has more than 20 vertices"}},
     {replaced(vtk, "9\n9", "9\n5"), ".vtk", 2, {"cell 1", "VTK type 5", "4 vertices"}},
     {replaced(vtk, "9\n9", "9\n42"), ".vtk", 2, {"cell 1", "VTK type 42", "hexahedra (3d)"}}});
}

TEST(MistakesInMeshes, InvertedCells)
{
  const std::vector<std::string> second = {"cell 2 (counted from 1 among the quadrilaterals)",
                                           "inverted or degenerate"};
  // All cells in the wrong direction are turned around; one that differs from others is refused.
  expect_two_squares(replaced(replaced(ucd, "2 5 6 3", "3 6 5 2"), "1 2 3 4", "4 3 2 1"), ".ucd");
  expect_mesh_refusals(
    {{replaced(ucd, "2 5 6 3", "3 6 5 2"), ".ucd", 2, second},
     {replaced(ucd, "6 2 1 0", "6 1.4 0.4 0"), ".ucd", 2, {second[0], second[1], "(1.4 0.4)"}},
     {replaced(ucd, "6 2 1 0", "6 1.5 0.5 0"), ".ucd", 2, {second[0], second[1], "(1.5 0.5)"}},
     {replaced(read_file("hammer.inp"),
               "\n186, 225, 240, 241, 220, 266, 281, 282, 261\n",
               "\n186, 266, 281, 282, 261, 225, 240, 241, 220\n"),
      ".inp",
      3,
      {"cell 186 with the centre (1.375 ", "is inverted", "Correct the order"}},
     {replaced(read_file("anvil.msh"), "101 -0.346666667", "101 5"),
      ".msh",
      3,
      {"among the hexahedra", "inverted or degenerate at its vertex", "-0.6)"}}});
}

TEST(MistakesInMeshes, CellWithOneVertexTwice)
{
  expect_mesh_refusals(
    {{replaced(ucd, "2 5 6 3", "2 5 6 6"),
      ".ucd",
      2,
      {"cell 2 (counted from 1 among the quadrilaterals)", "inverted or degenerate", "(2 1)"}}});
}

TEST(MistakesInMeshes, References)
{
  expect_mesh_refusals(
    {{replaced(ucd, "2 5 6 3", "2 5 9 3"),
      ".ucd",
      2,
      {"cell 2 has the vertex 9", "does not exist"}},
     {replaced(ucd, "line 1 2", "line 1 9"),
      ".ucd",
      2,
      {"cell 3 has the vertex 9", "does not exist"}},
     {replaced(vtk, "4 1 4 5 2", "4 1 4 6 2"),
      ".vtk",
      2,
      {"cell 1", "the point 6", "does not exist"}},
     {replaced(vtk, "9\n9", "9\n12"), ".vtk", 2, {"cell 1", "VTK type 12", "4 vertices"}},
     {replaced(vtk, "CELL_TYPES", "CELLS 0 0\nCELL_TYPES"), ".vtk", 2, {"`CELLS` twice"}},
     {replaced(msh, "2 5 6 3", "2 5 9 3"), ".msh", 2, {"index 9", "Write the mesh again"}},
     {replaced(msh, "7 7 1 2", "7 7 2 3"), ".msh", 2, {"internal face", "boundary only"}},
     {replaced(msh_4, "1 6 1 6", "1 5 1 6"), ".msh", 2, {"announces 5 nodes and has 6"}},
     {replaced(inp, "11, S1", "13, S1"), ".inp", 2, {"SURF-7", "element 13", "does not exist"}},
     {replaced(inp, "11, S1", "left, S1"), ".inp", 2, {"SURF-7", "no element set `LEFT`"}},
     {replaced(inp, "11, S1", "11, S5"), ".inp", 2, {"element 11 has no face 5"}},
     {replaced(inp, "11, S1", "11, SPOS"), ".inp", 2, {"`11, SPOS`", "faces of elements"}},
     {replaced(inp, "*Step", "*Surface, name=Surf-8\n11, S1\n*Step"),
      ".inp",
      2,
      {"numbers 7 and 8"}},
     {replaced(inp, "12, 2", "11, 2"), ".inp", 2, {"element 11 is given twice"}},
     {replaced(inp, "4, 0., 1.", "3, 0., 1."), ".inp", 2, {"node 3 is given twice"}},
     {replaced(inp, "2, 5, 6, 3", "2, 5, 9, 3"), ".inp", 2, {"cell 12 has the vertex 9"}}});
}

TEST(MistakesInMeshes, WhereverAFileIsCutItIsRefused)
{
  // The end of the last line may be missing. Abaqus files have no end: a cut between two elements
  // goes unnoticed.
  const std::vector<std::pair<std::string, std::string>> meshes = {
    {ucd, ".ucd"},
    {vtk, ".vtk"},
    {msh, ".msh"},
    {msh_4, ".msh"},
    {inp.substr(0, inp.find("\n12")), ".inp"}};
  for (const auto &[mesh, extension] : meshes)
    for (std::size_t length = 0; length + 2 < mesh.size(); length += 5)
      EXPECT_NE(message_about(mesh.substr(0, length), extension, 2), "") << mesh.substr(0, length);
}
