// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/mesh_numbers.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Section Nodes of version 2 to 4.1: as many as announced? deal.II relies on it. */
    void check_gmsh_nodes(std::istream &in, const double version)
    {
      const std::string where    = "the section `$Nodes`";
      const auto        n_blocks = (version < 4. ? 1u : next<unsigned int>(in, where));
      const auto        n_nodes  = next<unsigned long>(in, where);
      if (version > 4.)
        skip_numbers(in, 2, where); // smallest and largest number of a node
      unsigned long n_found = 0;
      for (unsigned int block = 0; block < n_blocks; ++block)
        {
          if (version >= 4.)
            skip_numbers(in, 3, where);
          const auto n = (version < 4. ? n_nodes : next<unsigned long>(in, where));
          skip_numbers(in, n, where);     // numbers of nodes
          skip_numbers(in, 3 * n, where); // coordinates
          n_found += n;
        }
      if (n_found != n_nodes)
        throw MeshFileError("the file is broken: " + where + " announces " + std::to_string(n_nodes)
                            + " nodes and has " + std::to_string(n_found) + ". "
                            + MeshFileError::remedy);
    }
  } // namespace

  namespace
  {
    /** Section Elements of version 2 to 4.1: only points, lines, quadrilaterals and hexahedra? */
    void check_gmsh_elements(std::istream &in, const double version)
    {
      const std::string where = "the section `$Elements`";
      // By type: the number of nodes. Others have triangles, or nodes in the middle of edges.
      const std::map<unsigned int, unsigned int> n_nodes_of = {{15, 1}, {1, 2}, {3, 4}, {5, 8}};
      const std::set<unsigned int>               with_triangles{2, 4, 6, 7};
      const auto                                 n_nodes = [&](const unsigned int type) {
        const auto  found = n_nodes_of.find(type);
        const auto &remedy =
          with_triangles.count(type) > 0 ? MeshFileError::subdivide : MeshFileError::first_order;
        if (found == n_nodes_of.end())
          throw MeshFileError(
            "it has elements of Gmsh's type " + std::to_string(type)
            + ". Only quadrilaterals with 4 nodes (2d, type 3) and hexahedra with "
                                              "8 (3d, type 5) can be used. "
            + remedy);
        return found->second;
      };
      const auto n_blocks = next<unsigned long>(in, where); // version 2: elements
      if (version >= 4.)
        skip_numbers(in, version > 4. ? 3 : 1, where);
      for (unsigned long block = 0; block < n_blocks; ++block)
        if (version < 4.)
          {
            next<unsigned long>(in, where);
            const auto type = next<unsigned int>(in, where), n_tags = next<unsigned int>(in, where);
            skip_numbers(in, n_tags + n_nodes(type), where);
          }
        else
          {
            skip_numbers(in, 2, where);
            const auto type = next<unsigned int>(in, where);
            skip_numbers(in, next<unsigned long>(in, where) * (1 + n_nodes(type)), where);
          }
    }
  } // namespace

  void check_gmsh(const std::string &text)
  {
    std::istringstream    in(text);
    std::string           line, open;
    std::set<std::string> sections;
    double                version = 1.;
    while (std::getline(in, line))
      {
        line = trim(line);
        if (line.empty() || line[0] != '$')
          continue;
        const bool ends = line.rfind("$End", 0) == 0 || line.rfind("$END", 0) == 0;
        if (ends ? line.substr(4) != open : !open.empty())
          throw MeshFileError("the file is broken: the section `$" + open + "` has no end before `"
                              + line + "`. " + MeshFileError::remedy);
        open = ends ? "" : line.substr(1);
        sections.insert(line.substr(1));
        if (line == "$Nodes")
          check_gmsh_nodes(in, version);
        if (line == "$Elements")
          check_gmsh_elements(in, version);
        if (line == "$MeshFormat" && std::getline(in, line))
          {
            std::istringstream numbers(line);
            version = next<double>(numbers, "the section `$MeshFormat`");
            if (next<int>(numbers, "the section `$MeshFormat`") != 0 || version < 2.
                || version > 4.1)
              throw MeshFileError(
                "the version of the Gmsh file, `" + trim(line)
                + "`, is not known. Save it as text (ASCII) in version 2.2 or 4.1.");
          }
      }
    if (!open.empty())
      throw MeshFileError("the file is broken: it ends in the section `$" + open + "`. "
                          + MeshFileError::remedy);
    if (sections.count("Nodes") + sections.count("NOD") == 0
        || sections.count("Elements") + sections.count("ELM") == 0)
      throw MeshFileError(
        "it is not a Gmsh mesh: it has no section `$Nodes` or no section `$Elements`. "
        + MeshFileError::remedy);
  }

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
    for (std::string word; in >> word;)
      if (word == "POINTS")
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
