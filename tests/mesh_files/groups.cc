// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Names of groups stand for boundary ids and for parts of a file wherever a scene has them, and
// numbers stay what they are. A name that is not there is refused with a list of those that are. A
// scale changes the unit of length. Cells that overlap are named.

#include "../scene/scene_file.h"
#include "mesh_texts.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** Two cubes of tetrahedra above each other, each a physical volume, in one file. */
  std::string two_cubes(const double distance)
  {
    const MeshTexts    cube    = cube_of_tetrahedra();
    const std::string  names[] = {"lower", "Upper cube"};
    std::ostringstream nodes, elements;
    int                n_nodes = 0, n_elements = 0;
    for (int k = 0; k < 2; ++k)
      {
        const int first = n_nodes + 1;
        for (const auto &point : cube.points)
          nodes << ++n_nodes << ' ' << point[0] << ' ' << point[1] << ' '
                << point[2] + k * (1. + distance) << '\n';
        for (const auto &group : {cube.cells, cube.faces[0], cube.faces[1]})
          for (const auto &element : group.elements)
            {
              const bool is_cell = element.size() == 4;
              elements << ++n_elements << ' ' << (is_cell ? 4 : 2) << " 2 "
                       << (is_cell ? 50 + k : group.number + 2 * k) << " 1 "
                       << row(element, " ", first) << '\n';
            }
      }
    std::ostringstream out;
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n";
    for (int k = 0; k < 2; ++k)
      out << "3 " << 50 + k << " \"" << names[k] << "\"\n";
    out << "2 1 \"clamp\"\n2 2 \"top\"\n2 3 \"Contact face\"\n$EndPhysicalNames\n$Nodes\n"
        << n_nodes << '\n'
        << nodes.str() << "$EndNodes\n$Elements\n"
        << n_elements << '\n'
        << elements.str() << "$EndElements\n";
    return out.str();
  }

  /** Both cubes as bodies; the upper one falls. */
  std::string scene_of(const std::string &mesh)
  {
    return "set Dimension = 3\nsubsection Time\nset Step size = 1e-3\nset End time = 1e-2\nend\n"
           "subsection Bodies\nset Names = hammer, anvil\nsubsection hammer\nset Shape = file\n"
           "set File = "
           + mesh
           + "\nset Part = upper cube\nset Scale = 0.001\nset Initial velocity = 0; 0; -1\nend\n"
             "subsection anvil\nset Shape = file\nset File = "
           + mesh
           + "\nset Part = 50\nset Scale = 0.001\nset Dirichlet = clamp: 0; 0; 0\nend\nend\n"
             "subsection Contact\nset Pairs = hammer[Contact face] : anvil[top]\nend\n";
  }

  const std::string friction = "subsection Contact\nsubsection hammer[Contact face] : anvil[top]\n"
                               "set Friction coefficient = 0.1\nend\nend\n";

  std::string refusal_of_box_mesh(const std::string &mesh, const std::string &extension)
  {
    const TemporaryFile file(mesh, extension);
    const TemporaryFile scene(
      "set Dimension = 3\n" + assignment("Time/Step size", "1e-2")
      + assignment("Time/End time", "1") + assignment("Bodies/Names", "body")
      + assignment("Bodies/body/Shape", "file") + assignment("Bodies/body/File", file.name));
    return refusal(scene.name);
  }
} // namespace


TEST(Groups, NameBoundariesAndParts)
{
  const TemporaryFile mesh(two_cubes(0.5), ".msh"), file(scene_of(mesh.name) + friction);
  const Scene<3>      scene  = read_scene<3>(file.name, {});
  const auto         &hammer = scene.bodies[0], &anvil = scene.bodies[1];
  using Ids = std::vector<dealii::types::boundary_id>;
  EXPECT_EQ(hammer.shape->boundary_ids(), (Ids{0, 3, 4}));
  EXPECT_EQ(anvil.shape->boundary_ids(), (Ids{0, 1, 2}));
  EXPECT_NEAR(mesh_of(hammer).centre[2], 2e-3, 1e-15);
  EXPECT_NEAR(mesh_of(anvil).centre[2], .5e-3, 1e-15);
  ASSERT_EQ(anvil.dirichlet.size(), 1u);
  EXPECT_EQ(anvil.dirichlet[0].boundary_id, 1u);
  ASSERT_EQ(scene.pairs.size(), 1u);
  EXPECT_EQ(scene.pairs[0].slave_boundary_ids, Ids{3});
  EXPECT_EQ(scene.pairs[0].master_boundary_ids, Ids{2});
  EXPECT_EQ(scene.pairs[0].friction.coefficient, "0.1");
  EXPECT_EQ(list_of_boundaries(*anvil.shape), "0, 1 (clamp), 2 (top)");

  // What is written for the next run says the same.
  const TemporaryFile again(scene.all_parameters);
  EXPECT_EQ(read_scene<3>(again.name, {}).all_parameters, scene.all_parameters);
}


TEST(Groups, OtherNamesAreRefusedWithAList)
{
  const TemporaryFile mesh(two_cubes(0.5), ".msh"), file(scene_of(mesh.name));
  const auto          with = [&](const std::string &key, const std::string &value) {
    return refusal(file.name, {{key, value}});
  };
  expect_words(with("Bodies/hammer/Part", "lowr"),
               {"Bodies/hammer/Part", "no group of cells `lowr`", "Did you mean `lower`?"});
  expect_words(
    with("Bodies/anvil/Dirichlet", "clam: 0; 0; 0"),
    {"Bodies/anvil/Dirichlet", "no boundary id `clam`", "Valid: 0, 1 (clamp), 2 (top)."});
  expect_words(with("Contact/Pairs", "hammer[top] : anvil[2]"),
               {"no boundary id top", "Valid: 0, 3 (Contact face), 4."});
  expect_words(with("Contact/Pairs", "hammer[3] : anvil, hammer[contactface] : anvil[2]"),
               {"are the same contact twice"});
  expect_words(with("Bodies/anvil/Scale", "0"), {"Bodies/anvil/Scale", "unit of length"});
}


// One id cannot say that a face belongs to two groups; each combination has its own.
TEST(Groups, MayHaveFacesInCommon)
{
  const std::string   surfaces = "*SURFACE, NAME=SS7\n1, S1\n2, S1\n*SURFACE, NAME=FIRST\n1, S1\n";
  const TemporaryFile mesh("*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 2, 0\n6, 2, 1\n"
                           "*ELEMENT, TYPE=CPE4\n1, 1, 2, 3, 4\n2, 2, 5, 6, 3\n"
                             + surfaces,
                           ".inp");
  const TemporaryFile scene(
    "set Dimension = 2\n" + assignment("Time/Step size", "1e-2") + assignment("Time/End time", "1")
    + assignment("Bodies/Names", "plate") + assignment("Bodies/plate/Shape", "file")
    + assignment("Bodies/plate/File", mesh.name) + assignment("Bodies/plate/Dirichlet", "7: 0; 0"));
  const auto body = read_scene<2>(scene.name, {}).bodies[0];
  using Ids       = std::vector<dealii::types::boundary_id>;
  EXPECT_EQ(body.shape->boundary_ids(), (Ids{0, 7, 8}));
  EXPECT_EQ(boundary_ids_named(*body.shape, "ss7").size(), 2u);
  EXPECT_EQ(boundary_ids_named(*body.shape, "7").size(), 2u);
  EXPECT_EQ(boundary_ids_named(*body.shape, "first"), (Ids{8}));
  EXPECT_EQ(body.dirichlet.size(), 2u);
}


TEST(Groups, AllCellsOfAFileMustBeApart)
{
  expect_words(refusal_of_box_mesh(two_cubes(-0.4), ".msh"),
               {"(a tetrahedron)", "overlap", "`Part`"});
  EXPECT_EQ(refusal_of_box_mesh(two_cubes(0.), ".msh"), "");
  // A corner that has gone through the opposite face.
  MeshTexts cube = cube_of_tetrahedra();
  cube.points[1] = {0.2, 0.9, 0.9};
  expect_words(refusal_of_box_mesh(cube.gmsh_2(), ".msh"), {"(a tetrahedron)", "same side"});
  cube                = cube_of_tetrahedra();
  cube.cells.elements = {{0, 1, 3, 7}, {0, 1, 3, 7}};
  expect_words(refusal_of_box_mesh(cube.ucd(), ".ucd"), {"the same cell twice"});
  cube.points[7] = {0.5, 0.3, 0.};
  cube.cells.elements.pop_back();
  expect_words(refusal_of_box_mesh(cube.ucd(), ".ucd"),
               {"cell 1 (a tetrahedron) is inverted or degenerate at its vertex (0 0 0)"});
}
