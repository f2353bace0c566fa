// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_numbers.h>
#include <signorini/mesh_files/mesh_text.h>

#include <map>
#include <set>
#include <sstream>

namespace signorini
{
  void check_ucd(const std::string &text)
  {
    const std::map<std::string, unsigned int> n_vertices_of = {{"pt", 1},
                                                               {"line", 2},
                                                               {"tri", 3},
                                                               {"quad", 4},
                                                               {"tet", 4},
                                                               {"pyr", 5},
                                                               {"prism", 6},
                                                               {"hex", 8}};
    std::istringstream                        in(text);
    for (std::string comment; in.peek() == '#';)
      std::getline(in, comment);
    const auto n_vertices = next<unsigned int>(in, "the first line"),
               n_cells    = next<unsigned int>(in, "the first line");
    skip_numbers(in, 3, "the first line");
    std::set<long> vertices;
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        vertices.insert(next<long>(in, "the list of vertices"));
        skip_numbers(in, 3, "the list of vertices");
      }
    bool has_cells = false;
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        const auto number = next<long>(in, "the list of cells");
        next<unsigned int>(in, "the list of cells");
        const auto type  = next<std::string>(in, "the list of cells");
        const auto found = n_vertices_of.find(type);
        if (found == n_vertices_of.end())
          throw MeshFileError("cell " + std::to_string(number) + " has the type `" + type
                              + "`, which is not known. " + MeshFileError::remedy);
        has_cells = has_cells || type == "quad" || type == "hex";
        if (type != "line" && type != "quad" && type != "hex")
          throw MeshFileError("cell " + std::to_string(number) + " is of type `" + type
                              + "`. Only quadrilaterals (2d) and hexahedra (3d) can be used. "
                              + MeshFileError::subdivide);
        for (unsigned int v = 0; v < found->second; ++v)
          {
            const auto vertex = next<long>(in, "the list of cells");
            if (vertices.count(vertex) == 0)
              throw MeshFileError("the file is broken: cell " + std::to_string(number)
                                  + " has the vertex " + std::to_string(vertex)
                                  + ", which does not exist. " + MeshFileError::remedy);
          }
      }
    if (!has_cells)
      throw MeshFileError("it has no quadrilaterals and no hexahedra. " + MeshFileError::remedy);
  }

  namespace
  {
    /** Section CELLS: the vertices of each cell. @return how many each has */
    std::vector<unsigned int> check_vtk_cells(std::istream &in, const long n_points)
    {
      std::vector<unsigned int> n_vertices;
      const auto                n_cells = next<unsigned int>(in, "`CELLS`");
      next<unsigned int>(in, "`CELLS`");
      refuse_offsets(in);
      for (unsigned int c = 0; c < n_cells; ++c)
        {
          n_vertices.push_back(next<unsigned int>(in, "the list of cells"));
          for (unsigned int v = 0; v < n_vertices.back(); ++v)
            {
              const auto point = next<long>(in, "the list of cells");
              if (point < 0 || point >= n_points)
                throw MeshFileError("the file is broken: cell " + std::to_string(c)
                                    + " (counted from 0) has the point " + std::to_string(point)
                                    + ", which does not exist. " + MeshFileError::remedy);
            }
        }
      return n_vertices;
    }

    std::string remedy_for_vtk(const unsigned int type)
    {
      if (type == 1)
        return "Points are what Gmsh writes for a mesh without physical groups; save it as .msh.";
      return type > 20 ? MeshFileError::first_order : MeshFileError::subdivide;
    }

    void check_vtk_types(std::istream &in, const std::vector<unsigned int> &n_vertices)
    {
      const std::map<unsigned int, unsigned int> n_vertices_of = {
        {3, 2}, {9, 4}, {12, 8}}; // line, quad, hexahedron
      next<unsigned int>(in, "`CELL_TYPES`");
      for (unsigned int c = 0; c < n_vertices.size(); ++c)
        {
          const auto type  = next<unsigned int>(in, "the list of cell types");
          const auto found = n_vertices_of.find(type);
          if (found == n_vertices_of.end())
            throw MeshFileError(
              "cell " + std::to_string(c) + " (counted from 0) has the VTK type "
              + std::to_string(type)
              + ". Only quadrilaterals (2d, type 9) and hexahedra (3d, type 12) can be used. "
              + remedy_for_vtk(type));
          if (found->second != n_vertices[c])
            throw MeshFileError("the file is broken: cell " + std::to_string(c)
                                + " (counted from 0) of VTK type " + std::to_string(type) + " has "
                                + std::to_string(n_vertices[c]) + " vertices. "
                                + MeshFileError::remedy);
        }
    }
  } // namespace

  void check_vtk(const std::string &text)
  {
    std::istringstream        in(text);
    std::vector<unsigned int> n_vertices;
    long                      n_points  = -1;
    bool                      has_types = false;
    std::set<std::string>     sections;
    for (std::string word; in >> word;)
      if ((word == "POINTS" || word == "CELLS" || word == "CELL_TYPES")
          && !sections.insert(word).second)
        throw MeshFileError("the file is broken: it has the section `" + word + "` twice. "
                            + MeshFileError::remedy);
      else if (word == "POINTS")
        {
          n_points = next<unsigned int>(in, "`POINTS`");
          in >> word;
          skip_numbers(in, 3 * n_points, "the list of points");
        }
      else if (word == "CELLS")
        n_vertices = check_vtk_cells(in, n_points);
      else if (word == "CELL_TYPES")
        {
          check_vtk_types(in, n_vertices);
          has_types = true;
        }
    if (!has_types)
      throw MeshFileError("it is not a VTK file (legacy format) with an unstructured grid: "
                          "`POINTS`, `CELLS` or `CELL_TYPES` is missing. "
                          + MeshFileError::remedy);
  }
} // namespace signorini
