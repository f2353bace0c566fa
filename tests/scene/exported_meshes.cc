// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What Gmsh, ParaView and meshio write when nobody has told them otherwise is read, or refused with
// the setting that helps. The meshes are one square, or one cube, as these programs write it.

#include "scene_file.h"

#include <gtest/gtest.h>

#include <set>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  std::string scene_of(const std::string &mesh_file, const unsigned int dim)
  {
    return "set Dimension = " + std::to_string(dim) + "\n" + assignment("Time/Step size", "1e-2")
           + assignment("Time/End time", "1") + assignment("Bodies/Names", "body")
           + assignment("Bodies/body/Shape", "file") + assignment("Bodies/body/File", mesh_file);
  }

  std::string
  refusal_of_mesh(const std::string &mesh, const std::string &extension, const unsigned int dim)
  {
    const TemporaryFile file(mesh, extension);
    const TemporaryFile scene(scene_of(file.name, dim));
    return refusal(scene.name);
  }

  /** The boundary ids of a mesh of one square. */
  std::vector<dealii::types::boundary_id> ids_of_square(const std::string &mesh,
                                                        const std::string &extension)
  {
    const TemporaryFile                     file(mesh, extension);
    const TemporaryFile                     scene_file(scene_of(file.name, 2));
    const Scene<2>                          scene = read_scene<2>(scene_file.name, {});
    std::vector<dealii::types::boundary_id> ids;
    for (const auto &[id, vertices] : mesh_of(scene.bodies[0]).boundary_vertices)
      ids.push_back(id);
    return ids;
  }

  using Ids = std::vector<dealii::types::boundary_id>;

  /** Names and numbers of groups of faces of a mesh of one cube. */
  std::set<std::string> names_of_cube(const std::string &mesh)
  {
    const TemporaryFile   file(mesh, ".inp");
    const TemporaryFile   scene_file(scene_of(file.name, 3));
    const Scene<3>        scene = read_scene<3>(scene_file.name, {});
    std::set<std::string> names;
    for (const auto &[name, ids] : mesh_of(scene.bodies[0]).boundaries)
      names.insert(name);
    return names;
  }

  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

  const std::string vtk_of_gmsh =
    "# vtk DataFile Version 2.0\nsquare, Created by Gmsh 4.8.4 \nASCII\nDATASET UNSTRUCTURED_GRID\n"
    "POINTS 4 double\n"
    + points
    + "\nCELLS 3 11\n2 0 1\n2 1 2\n4 0 1 2 3\n\nCELL_TYPES 3\n3\n3\n9\n\nCELL_DATA 3\n"
      "SCALARS CellEntityIds int 1\nLOOKUP_TABLE default\n1\n2\n1\n";
} // namespace

TEST(ExportedMeshes, AbaqusFilesOfGmsh)
{
  const std::string head =
    "*Heading\n square.inp\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, "
    "1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n******* E L E M E "
    "N T S *************\n";
  const std::string faces = "*ELEMENT, type=CPS4, ELSET=Surface1\n2, 1, 2, 3, 4\n";
  EXPECT_EQ(refusal_of_mesh(head + faces, ".inp", 2), "");
  // Elements of faces are groups by their sets: those of the geometry, or else those of the user.
  EXPECT_EQ(ids_of_square(head + "*ELEMENT, type=T3D2, ELSET=Line1\n1, 1, 2\n" + faces, ".inp"),
            (Ids{0, 1}));
  const std::string cube =
    head + faces + "*ELEMENT, type=C3D8, ELSET=Volume1\n3, 1, 2, 3, 4, 5, 6, 7, 8\n";
  EXPECT_EQ(names_of_cube(cube), (std::set<std::string>{"1", "SURFACE1"}));
  EXPECT_EQ(names_of_cube(cube + "*ELSET, ELSET=below\n2\n*ELSET, ELSET=all\n3\n"),
            (std::set<std::string>{"1", "BELOW"}));
}

TEST(ExportedMeshes, VtkFilesOfGmsh)
{
  EXPECT_EQ(ids_of_square(vtk_of_gmsh, ".vtk"), Ids{0});
  std::string with_point = vtk_of_gmsh;
  with_point.replace(with_point.find("CELLS 3 11\n2 0 1"), 16, "CELLS 3 10\n1 0");
  with_point.replace(with_point.find("CELL_TYPES 3\n3"), 14, "CELL_TYPES 3\n1");
  expect_words(refusal_of_mesh(with_point, ".vtk", 2),
               {"VTK type 1", "without physical groups", "save it as .msh"});
  std::string quadratic = vtk_of_gmsh;
  quadratic.replace(quadratic.find("\n9\n"), 3, "\n23\n");
  expect_words(refusal_of_mesh(quadratic, ".vtk", 2), {"VTK type 23", "4 vertices"});
}

TEST(ExportedMeshes, VtkFilesOfVersion5)
{
  expect_words(
    refusal_of_mesh("# vtk DataFile Version 5.1\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                    "POINTS 4 double\n"
                      + points
                      + "CELLS 2 4\nOFFSETS vtktypeint64\n0 4 \nCONNECTIVITY vtktypeint64\n"
                        "0 1 2 3 \n\nCELL_TYPES 1\n9\n",
                    ".vtk",
                    2),
    {"as VTK 5 does", "version 4.2", "vtk42"});
}

TEST(ExportedMeshes, BinaryFilesOfGmsh)
{
  using namespace std::string_literals;
  expect_words(refusal_of_mesh("$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n"s, ".msh", 2),
               {"binary", "text (ASCII)", "Mesh.Binary = 0"});
}

TEST(ExportedMeshes, FilesOfGmshWithoutPhysicalGroups)
{
  const std::string version_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
    "$EndNodes\n$Elements\n6\n1 15 2 0 1 1\n2 1 2 0 1 1 2\n3 1 2 0 2 2 3\n4 1 2 0 3 3 4\n"
    "5 1 2 0 4 4 1\n6 3 2 0 1 1 2 3 4\n$EndElements\n";
  const std::string version_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 1 1 0\n1 0 0 0 0 \n1 0 0 0 1 0 0 0 2 1 -2 "
    "\n"
    "1 0 0 0 1 1 0 0 1 1 \n$EndEntities\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 "
    "0\n0 1 0\n$EndNodes\n$Elements\n3 3 1 3\n0 1 15 1\n1 1 \n1 1 1 1\n2 1 2 \n2 1 3 1\n3 1 2 3 4 "
    "\n$EndElements\n";
  EXPECT_EQ(ids_of_square(version_2, ".msh"), Ids{0});
  EXPECT_EQ(ids_of_square(version_4, ".msh"), Ids{0});
}
