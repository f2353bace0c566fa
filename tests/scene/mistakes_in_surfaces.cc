// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A mesh file that is not the surface of an obstacle is refused with one clear sentence that says
// where and what to do, and nothing crashes; the same surface is read from all formats.

#include "scene_file.h"

#include <gtest/gtest.h>

#include <cstdint>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  std::string
  scene_with_obstacle(const std::string &file, const unsigned int dim, const std::string &more = "")
  {
    return "set Dimension = " + std::to_string(dim) + "\n" + assignment("Time/Step size", "1e-2")
           + assignment("Time/End time", "1") + assignment("Bodies/Names", "body")
           + assignment("Bodies/body/Shape", "box") + assignment("Obstacles/Names", "rock")
           + assignment("Obstacles/rock/Shape", "mesh") + assignment("Obstacles/rock/File", file)
           + more;
  }

  struct SurfaceMistake
  {
    std::string              mesh, extension;
    unsigned int             dim;
    std::vector<std::string> words;
    std::string              more = "";
  };

  void expect_surface_refusals(const std::vector<SurfaceMistake> &mistakes)
  {
    for (const SurfaceMistake &mistake : mistakes)
      {
        SCOPED_TRACE(mistake.extension + " in " + std::to_string(mistake.dim) + "d:\n"
                     + mistake.mesh.substr(0, 600));
        const TemporaryFile file(mistake.mesh, mistake.extension);
        const TemporaryFile scene(scene_with_obstacle(file.name, mistake.dim, mistake.more));
        const std::string   message = refusal(scene.name);
        expect_words(message, {scene.name + ", line ", "Obstacles/rock/File = " + file.name});
        expect_words(message, mistake.words);
      }
  }

  template <int dim>
  void expect_gap(const std::string        &mesh,
                  const std::string        &extension,
                  const dealii::Point<dim> &point,
                  const double              gap,
                  const std::string        &more = "")
  {
    const TemporaryFile file(mesh, extension);
    const TemporaryFile scene(scene_with_obstacle(file.name, dim, more));
    ASSERT_EQ(refusal(scene.name), "") << mesh;
    const auto obstacle = read_scene<dim>(scene.name, {}).obstacles[0];
    EXPECT_NEAR(obstacle.shape->project(point).gap, gap, 1e-6) << extension << mesh;
  }

  // A tetrahedron with the unit vectors as corners.
  const std::string tetrahedron =
    "# corners\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1/1/1 2/2/1 "
    "4/4/1\nf -3 -2 -1\nf 3 1 4\n";
  const std::string vtk_polygons =
    "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0\n1 0 0\n0 1 "
    "0\n0 0 1\nPOLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const std::string vtk_cells =
    "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 "
    "0 0\n0 1 0\n0 0 1\nCELLS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\nCELL_TYPES 4\n5\n5\n5\n5\n";
  // The two as VTK 5 writes them.
  const std::string vtk_5_polygons =
    "# vtk DataFile Version 5.1\nmesh\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 "
    "0 0 1 \n\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12 \nCONNECTIVITY vtktypeint64\n0 2 1 "
    "0 1 3 1 2 3 2 0 3 \n";
  const std::string vtk_5_cells =
    "# vtk DataFile Version 5.1\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 "
    "0 0 0 1 0 0 0 1 \n\nCELLS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12 \nCONNECTIVITY "
    "vtktypeint64\n0 2 1 0 1 3 1 2 3 2 0 3 \n\nCELL_TYPES 4\n5\n5\n5\n5\n";
  const std::string ucd_cube =
    "8 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 "
    "1\n8 0 1 1\n1 0 hex 1 2 "
    "3 4 5 6 7 8\n";
  const std::string closed_line = "v 0 0\nv 1 0\nv 1 1\nv 0 1\nl 1 2 3 4 1\n";

  std::string tetrahedron_stl()
  {
    std::string text = "solid rock\n";
    for (const char *triangle :
         {"0 0 0:0 1 0:1 0 0", "0 0 0:1 0 0:0 0 1", "1 0 0:0 1 0:0 0 1", "0 1 0:0 0 0:0 0 1"})
      {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const std::string &corner : split(triangle, ':'))
          text += "vertex " + corner + "\n";
        text += "endloop\nendfacet\n";
      }
    return text + "endsolid rock\n";
  }

  /** The same facets as in tetrahedron_stl(), `announced` as any number. */
  std::string tetrahedron_binary_stl(const std::uint32_t announced)
  {
    std::string content(80, ' ');
    content.append(reinterpret_cast<const char *>(&announced), 4);
    const float corners[4][9] = {{0, 0, 0, 0, 1, 0, 1, 0, 0},
                                 {0, 0, 0, 1, 0, 0, 0, 0, 1},
                                 {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                 {0, 1, 0, 0, 0, 0, 0, 0, 1}};
    for (const auto &triangle : corners)
      {
        content.append(12, '\0');
        content.append(reinterpret_cast<const char *>(triangle), sizeof(triangle));
        content.append(2, '\0');
      }
    return content;
  }
} // namespace

// A zero byte would end the message in its middle, before the remedy.
TEST(MistakesInSurfaces, BytesThatAreNoText)
{
  const std::string zero(1, '\0');
  expect_surface_refusals({{"v 0 0 " + zero + "\n" + tetrahedron, ".obj", 3, {"binary", "ASCII"}},
                           {vtk_polygons + zero, ".vtk", 3, {"binary", "ASCII"}}});
}

TEST(MistakesInSurfaces, CorrectSurfacesAreRead)
{
  for (const auto &[mesh, extension] :
       std::vector<std::pair<std::string, std::string>>{{tetrahedron, ".obj"},
                                                        {vtk_polygons, ".vtk"},
                                                        {vtk_cells, ".vtk"},
                                                        {tetrahedron_stl(), ".stl"},
                                                        {tetrahedron_binary_stl(4), ".STL"}})
    {
      expect_gap<3>(mesh, extension, {0.2, 0.2, -0.5}, 0.5);
      expect_gap<3>(mesh, extension, {1., 1., 1.}, 2. / std::sqrt(3.));
      expect_gap<3>(mesh, extension, {0.1, 0.2, 0.2}, -0.1);
    }
  expect_gap<3>(ucd_cube, ".ucd", {0.5, 0.5, 1.5}, 0.5);
  expect_gap<3>(ucd_cube, ".ucd", {0.5, 0.5, 0.9}, -0.1);
  expect_gap<2>(closed_line, ".obj", {0.5, 1.25}, 0.25);
  expect_gap<2>(
    "4 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n1 0 quad 1 2 3 4\n", ".ucd", {0.5, 1.25}, 0.25);
}

// First the scale, then the rotation about the middle of the box around it, then the translation.
TEST(MistakesInSurfaces, PlacesOfSurfaces)
{
  const std::string place = assignment("Obstacles/rock/Scale", "2")
                            + assignment("Obstacles/rock/Rotation", "45")
                            + assignment("Obstacles/rock/Translation", "0, 3");
  expect_gap<2>(closed_line, ".obj", {1., 4. + std::sqrt(2.)}, 0., place);
  expect_gap<2>(closed_line, ".obj", {1. + 1.5 * std::sqrt(2.), 4.}, 0.5 * std::sqrt(2.), place);
  expect_gap<2>(
    closed_line, ".obj", {0.5, 0.75}, 0.25, assignment("Obstacles/rock/Bodies inside", "true"));
  expect_gap<2>(
    "v 1 0\nv 0 0\nl 1 2\n", ".obj", {0.5, 0.75}, 0.75, assignment("Obstacles/rock/Open", "true"));
}

TEST(MistakesInSurfaces, Files)
{
  const TemporaryFile none(scene_with_obstacle("", 3));
  expect_words(refusal(none.name), {"Obstacles/rock/File", "needs a surface", "Give the name"});
  const TemporaryFile missing(scene_with_obstacle("missing.stl", 3));
  expect_words(refusal(missing.name),
               {"Obstacles/rock/File = missing.stl", "no such file", "folder of the scene"});
  expect_surface_refusals(
    {{"hello", ".ply", 3, {"the extension `.ply` is not known", "Valid: .stl"}},
     {tetrahedron_stl(), ".stl", 2, {"surfaces in space", "Dimension = 2", ".obj"}},
     {"", ".stl", 3, {"is empty"}},
     {"hello", ".stl", 3, {"broken", "`solid`"}},
     {tetrahedron_binary_stl(5), ".stl", 3, {"broken", "5 facets"}},
     {"solid nothing\nendsolid\n", ".stl", 3, {"no facets"}},
     {"solid s\nvertex 0 0 0\nvertex 1 0 0\n", ".stl", 3, {"the middle of a facet"}},
     {"solid s\nvertex 0 0 zero\n", ".stl", 3, {"vertex 1", "three coordinates"}},
     {"v 0 0 0\nf 1 2 3\n", ".obj", 3, {"broken", "the vertex 1 (counted from 0)"}},
     {"v 0 0 0\nf 1 x 3\n", ".obj", 3, {"broken", "`x` is not the number of a vertex"}},
     {"v 0 0 0\nv 1 0 0\n", ".obj", 3, {"no facets"}},
     {closed_line, ".obj", 3, {"too few coordinates"}},
     {tetrahedron, ".obj", 2, {"z other than 0", "Dimension = 2"}},
     {"# vtk DataFile Version 3.0\nm\nBINARY\n", ".vtk", 3, {"`ASCII`"}},
     {vtk_polygons.substr(0, vtk_polygons.size() - 8), ".vtk", 3, {"broken", "POLYGONS"}},
     {vtk_5_polygons, ".vtk", 3, {"`OFFSETS`", "VTK 5", "version 4.2", "ParaView"}},
     {vtk_5_cells, ".vtk", 3, {"`OFFSETS`", "VTK 5", "version 4.2", "ParaView"}},
     {vtk_polygons.substr(0, vtk_polygons.find("3 0 2 1")) + "99 0 2 1\n",
      ".vtk",
      3,
      {"broken", "POLYGONS", "impossible number of vertices"}}});
}

TEST(MistakesInSurfaces, WhatIsNotTheBoundaryOfSomething)
{
  const std::string no_lid = tetrahedron.substr(0, tetrahedron.size() - 8);
  const auto        open   = assignment("Obstacles/rock/Open", "true");
  expect_surface_refusals(
    {{no_lid, ".obj", 3, {"not closed: 3 edges have a triangle on one side only", "Open = true"}},
     {tetrahedron, ".obj", 3, {"it has no end", "Remove `Open`"}, open},
     {tetrahedron + "v 1 1 1\nf 1 2 5\n",
      ".obj",
      3,
      {"3 triangles share one edge", "Remove facets"}},
     {"v 0 0\nv 1 0\nv 0 1\nv -1 0\nl 1 2\nl 1 3\nl 1 4\n",
      ".obj",
      2,
      {"at (0 0) 3 segments share one point"}},
     {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", ".obj", 3, {"triangle 1", "degenerate", "repair"}},
     {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n", ".obj", 3, {"encloses nothing"}},
     {"v 0 0\nv 1 0\nv 0 1\nv 2 2\nl 1 2 3 4 1\n", ".obj", 2, {"crosses itself near ("}},
     // A second tetrahedron, moved.
     {tetrahedron
        + "v .2 .2 -.2\nv 1.2 .2 -.2\nv .2 1.2 -.2\nv .2 .2 .8\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 "
          "8\n",
      ".obj",
      3,
      {"crosses itself near (", "Unite parts"}},
     // A band of Moebius, of five triangles.
     {"v 0 0 0\nv 1 0 0.3\nv 2 0 0\nv 2 1 1\nv 1 2 0.5\nf 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 "
      "2\n",
      ".obj",
      3,
      {"one side only", "Moebius"},
      open}});
}

TEST(MistakesInSurfaces, KeysOfOtherShapes)
{
  const TemporaryFile file(tetrahedron, ".obj");
  const TemporaryFile scene(
    scene_with_obstacle(file.name, 3, assignment("Obstacles/rock/Radius", "2")));
  expect_words(refusal(scene.name), {"Obstacles/rock/Radius = 2", "only for the shape"});
  const TemporaryFile scaled(
    scene_with_obstacle(file.name, 3, assignment("Obstacles/rock/Scale", "0")));
  expect_words(refusal(scaled.name), {"Obstacles/rock/Scale = 0", "must be positive"});
}
