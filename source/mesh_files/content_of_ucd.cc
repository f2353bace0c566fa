// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_content.h>
#include <signorini/mesh_files/mesh_numbers.h>
#include <signorini/mesh_files/mesh_text.h>

#include <sstream>

namespace signorini
{
  namespace
  {
    CellKind kind_with(const std::string &type, const long label)
    {
      static const std::map<std::string, CellKind> kinds = {{"pt", CellKind::point},
                                                            {"line", CellKind::line},
                                                            {"tri", CellKind::triangle},
                                                            {"quad", CellKind::quadrilateral},
                                                            {"tet", CellKind::tetrahedron},
                                                            {"pyr", CellKind::pyramid},
                                                            {"prism", CellKind::wedge},
                                                            {"hex", CellKind::hexahedron}};
      const auto                                   found = kinds.find(type);
      if (found == kinds.end())
        throw MeshFileError("cell " + std::to_string(label) + " has the type `" + type
                            + "`, which is not known. " + MeshFileError::remedy);
      return found->second;
    }
  } // namespace


  MeshContent content_of_ucd(const std::string &text)
  {
    MeshContent                  content;
    std::map<long, unsigned int> point_of_number;
    std::istringstream           in(text);
    for (std::string comment; in.peek() == '#';)
      std::getline(in, comment);
    const std::string head = "the first line", vertices = "the list of vertices",
                      cells = "the list of cells";
    const auto n_vertices = next<unsigned int>(in, head), n_cells = next<unsigned int>(in, head);
    skip_numbers(in, 3, head);
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        point_of_number[next<long>(in, vertices)] = content.points.size();
        content.points.emplace_back();
        for (unsigned int c = 0; c < 3; ++c)
          content.points.back()[c] = next<double>(in, vertices);
      }
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        MeshElement element;
        element.label          = next<long>(in, cells);
        const auto material    = next<long>(in, cells);
        element.kind           = kind_with(next<std::string>(in, cells), element.label);
        const CellShape &shape = shape_of(element.kind);
        element.groups         = content.group_of(shape.dim, material);
        std::vector<unsigned int> corners;
        for (unsigned int v = 0; v < shape.n_corners; ++v)
          {
            const auto vertex = next<long>(in, cells);
            const auto found  = point_of_number.find(vertex);
            if (found == point_of_number.end())
              throw MeshFileError("the file is broken: cell " + std::to_string(element.label)
                                  + " has the vertex " + std::to_string(vertex)
                                  + ", which does not exist. " + MeshFileError::remedy);
            corners.push_back(found->second);
          }
        content.add(element, corners, {});
      }
    return content;
  }
} // namespace signorini
