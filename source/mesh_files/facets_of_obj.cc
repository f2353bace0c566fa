// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/facet_mesh.h>
#include <signorini/mesh_files/mesh_text.h>

#include <sstream>

namespace signorini
{
  namespace
  {
    /** The vertices of a line `f` or `l`: `7`, `7/1/2` or, from the last one, `-1`. */
    std::vector<long> vertices_of_obj(std::istream &in, const long n_vertices)
    {
      std::vector<long> vertices;
      for (std::string word; in >> word;)
        {
          long               number = 0;
          std::istringstream first(word.substr(0, word.find('/')));
          if (!(first >> number) || number == 0)
            throw MeshFileError("the file is broken: `" + word + "` is not the number of a vertex. "
                                + MeshFileError::remedy);
          vertices.push_back(number > 0 ? number - 1 : n_vertices + number);
        }
      return vertices;
    }
  } // namespace


  template <int dim>
  FacetMesh<dim> facets_of_obj(const std::string &text)
  {
    FacetMesh<dim>     mesh;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      {
        std::istringstream in(line);
        std::string        kind;
        in >> kind;
        if (kind == "v")
          {
            std::array<double, 3> place = {{0., 0., 0.}};
            if (!(in >> place[0] >> place[1]) || (!(in >> place[2]) && dim == 3))
              throw MeshFileError("the file is broken: the line `" + line
                                  + "` has too few coordinates. " + MeshFileError::remedy);
            mesh.vertices.push_back(point_of_file<dim>(place));
          }
        else if (kind == (dim == 2 ? "l" : "f"))
          add_polygon(mesh, vertices_of_obj(in, mesh.vertices.size()));
      }
    return mesh;
  }

  template FacetMesh<2> facets_of_obj<2>(const std::string &);
  template FacetMesh<3> facets_of_obj<3>(const std::string &);
} // namespace signorini
