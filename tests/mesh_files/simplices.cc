// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A mesh of triangles or tetrahedra becomes one of quadrilaterals or hexahedra with the same
// volume, the same areas and the same groups, whatever the format of the file. Nodes in the middle
// of edges are vertices of it.

#include "../discretization/shapes.h"
#include "../scene/scene_file.h"
#include "mesh_texts.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;

namespace
{
  using Ids = std::vector<dealii::types::boundary_id>;

  template <int dim>
  BodyDescription<dim> body_of(const std::string &path, const std::string &part = "")
  {
    BodyDescription<dim> body;
    body.name  = "body";
    body.shape = std::make_shared<MeshFileShape<dim>>(describe_mesh_file<dim>(path, part));
    return body;
  }

  /** Volume, and area by boundary id, of a body from a file of this content. */
  template <int dim>
  void expect_block(const std::string        &text,
                    const std::string        &extension,
                    const unsigned int        n_cells,
                    const MeshTexts          &mesh,
                    const std::vector<double> areas)
  {
    SCOPED_TRACE(text);
    const TemporaryFile        file(text, extension);
    const BodyDescription<dim> body = body_of<dim>(file.name);
    const Meshed<dim>          meshed(body);
    EXPECT_EQ(meshed.triangulation.n_global_active_cells(), n_cells);
    EXPECT_NEAR(volume(meshed.triangulation), 1., 1e-12);
    const auto found = boundary_areas(meshed.triangulation);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NEAR(found.at(0), areas[0], 1e-12);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      {
        const auto ids       = boundary_ids_named(*body.shape, mesh.faces[f].name);
        const bool has_names = extension != ".ucd" && extension != ".vtk";
        EXPECT_EQ(ids, has_names ? boundary_ids_named(*body.shape, std::to_string(f + 1)) : Ids{});
        EXPECT_NEAR(found.at(f + 1), areas[f + 1], 1e-12);
      }
    expect_words(mesh_of(body).notes.at(0), {"are split into " + std::to_string(n_cells)});
  }

  /** Whether a mesh has this vertex. */
  template <int dim>
  bool has_vertex(const dealii::Triangulation<dim> &mesh, const Point<dim> &point)
  {
    for (const Point<dim> &vertex : mesh.get_vertices())
      if (vertex.distance(point) < 1e-12)
        return true;
    return false;
  }

  /** A mesh of one element in Gmsh's version 2.2. */
  std::string
  one_element(const std::vector<std::vector<double>> &points, const int type, const int n_nodes)
  {
    std::ostringstream out;
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << points.size() << '\n';
    for (std::size_t p = 0; p < points.size(); ++p)
      out << p + 1 << ' ' << row(points[p], " ", 0) << '\n';
    out << "$EndNodes\n$Elements\n1\n1 " << type << " 2 1 1";
    for (int node = 1; node <= n_nodes; ++node)
      out << ' ' << node;
    out << "\n$EndElements\n";
    return out.str();
  }
} // namespace


TEST(Simplices, AreSplitInEveryFormat)
{
  const MeshTexts cube = cube_of_tetrahedra(), square = square_of_triangles();
  for (const auto &[text, extension] : {std::pair(&MeshTexts::gmsh_2, ".msh"),
                                        std::pair(&MeshTexts::gmsh_4, ".msh"),
                                        std::pair(&MeshTexts::abaqus, ".inp"),
                                        std::pair(&MeshTexts::ucd, ".ucd"),
                                        std::pair(&MeshTexts::vtk, ".vtk")})
    {
      // The sets of Abaqus get their numbers in the order of their names.
      MeshTexts in_order = cube, square_in_order = square;
      if (std::string(extension) == ".inp")
        {
          in_order.faces[0].name = square_in_order.faces[0].name = "a";
          in_order.faces[1].name = square_in_order.faces[1].name = "b";
        }
      expect_block<3>((in_order.*text)(), extension, 24, in_order, {4., 1., 1.});
      expect_block<2>((square_in_order.*text)(), extension, 6, square_in_order, {2., 1., 1.});
    }
}


TEST(Simplices, TurnedAroundAreTurnedBack)
{
  MeshTexts all = cube_of_tetrahedra(), one = all;
  for (auto &cell : all.cells.elements)
    std::swap(cell[0], cell[1]);
  std::swap(one.cells.elements[3][0], one.cells.elements[3][1]);
  const TemporaryFile of_all(all.ucd(), ".ucd"), of_one(one.ucd(), ".ucd"),
    in_gmsh(one.gmsh_2(), ".msh");
  EXPECT_NEAR(volume(Meshed<3>(body_of<3>(of_all.name)).triangulation), 1., 1e-12);
  EXPECT_NEAR(volume(Meshed<3>(body_of<3>(in_gmsh.name)).triangulation), 1., 1e-12);
  EXPECT_THROW(body_of<3>(of_one.name), UserError);
}


// A quadrilateral beside a triangle, and a hexahedron beside a wedge.
TEST(Simplices, MixedMeshesAreSplitAsAWhole)
{
  const std::string   head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n";
  const TemporaryFile flat(head
                             + "5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n$EndNodes\n"
                               "$Elements\n2\n1 3 2 1 1 1 2 3 4\n2 2 2 1 1 2 5 3\n$EndElements\n",
                           ".msh");
  const TemporaryFile solid(head
                              + "10\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 "
                                "1\n8 0 1 1\n9 2 0 0\n10 2 0 1\n$EndNodes\n$Elements\n2\n"
                                "1 5 2 1 1 1 2 3 4 5 6 7 8\n2 6 2 1 1 2 9 3 6 10 7\n$EndElements\n",
                            ".msh");
  const Meshed<2>     meshed_flat(body_of<2>(flat.name));
  const Meshed<3>     meshed_solid(body_of<3>(solid.name));
  EXPECT_EQ(meshed_flat.triangulation.n_global_active_cells(), 4u + 3u);
  EXPECT_EQ(meshed_solid.triangulation.n_global_active_cells(), 8u + 6u);
  EXPECT_NEAR(volume(meshed_flat.triangulation), 1.5, 1e-12);
  EXPECT_NEAR(volume(meshed_solid.triangulation), 1.5, 1e-12);
}


TEST(Simplices, NodesInTheMiddleOfEdgesKeepTheCurve)
{
  const TemporaryFile file(
    one_element(
      {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {.5, 0., 0.}, {.6, .6, 0.}, {0., .5, 0.}}, 9, 6),
    ".msh");
  const BodyDescription<2> body = body_of<2>(file.name);
  dealii::Triangulation<2> mesh;
  read_mesh_file(file.name, mesh);
  EXPECT_TRUE(has_vertex(mesh, Point<2>(.6, .6)));
  // Of the quadratic map at the centre: the mean of the corners, and 4/9 of what a node is aside.
  EXPECT_TRUE(has_vertex(mesh, Point<2>(1. / 3. + .4 / 9., 1. / 3. + .4 / 9.)));
  EXPECT_NEAR(volume(Meshed<2>(body).triangulation), .5 + .1, 1e-12);
  expect_words(mesh_of(body).notes.at(0),
               {"1 triangle is split into 3 quad", "keep curved surfaces"});
}


// Gmsh lists the last two nodes of ten the other way round than VTK and Abaqus.
TEST(Simplices, CurvedTetrahedraAreTheSameInEveryFormat)
{
  const double                     r      = std::sqrt(.5);
  std::vector<std::vector<double>> points = {{0., 0., 0.},
                                             {1., 0., 0.},
                                             {0., 1., 0.},
                                             {0., 0., 1.},
                                             {.5, 0., 0.},
                                             {r, r, 0.},
                                             {0., .5, 0.},
                                             {0., 0., .5},
                                             {r, 0., r},
                                             {0., r, r}};
  std::ostringstream               inp, vtk;
  inp << "*NODE\n";
  vtk << "# vtk DataFile Version 3.0\nball\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 10 double\n";
  for (std::size_t p = 0; p < points.size(); ++p)
    {
      inp << p + 1 << ", " << row(points[p], ", ", 0) << '\n';
      vtk << row(points[p], " ", 0) << '\n';
    }
  inp << "*ELEMENT, TYPE=C3D10\n1, 1, 2, 3, 4, 5, 6, 7, 8,\n9, 10\n";
  vtk << "CELLS 1 11\n10 0 1 2 3 4 5 6 7 8 9\nCELL_TYPES 1\n24\n";
  std::swap(points[8], points[9]);
  for (const auto &[text, extension] : {std::pair(one_element(points, 11, 10), ".msh"),
                                        std::pair(inp.str(), ".inp"),
                                        std::pair(vtk.str(), ".vtk")})
    {
      SCOPED_TRACE(extension);
      const TemporaryFile      file(text, extension);
      dealii::Triangulation<3> mesh;
      read_mesh_file(file.name, mesh);
      ASSERT_EQ(mesh.n_active_cells(), 4u);
      unsigned int n_on_sphere = 0;
      for (const Point<3> &vertex : mesh.get_vertices())
        n_on_sphere += std::abs(vertex.norm() - 1.) < 1e-12;
      EXPECT_EQ(n_on_sphere, 6u);
      EXPECT_TRUE(has_vertex(mesh,
                             Point<3>(1. / 3. + 8. / 9. * (r - .5),
                                      1. / 3. + 8. / 9. * (r - .5),
                                      1. / 3. + 8. / 9. * (r - .5))));
    }
}


TEST(Simplices, CubesOfSecondOrderAreReducedToTheirCorners)
{
  const TemporaryFile      file(one_element({{0., 0., 0.},
                                             {1., 0., 0.},
                                             {1., 1., 0.},
                                             {0., 1., 0.},
                                             {.5, -.1, 0.},
                                             {1., .5, 0.},
                                             {.5, 1., 0.},
                                             {0., .5, 0.}},
                                       16,
                                       8),
                           ".msh");
  const BodyDescription<2> body = body_of<2>(file.name);
  const Meshed<2>          meshed(body);
  EXPECT_EQ(meshed.triangulation.n_global_active_cells(), 1u);
  EXPECT_NEAR(volume(meshed.triangulation), 1., 1e-12);
  expect_words(mesh_of(body).notes.at(0), {"of second order", "corners"});
}
