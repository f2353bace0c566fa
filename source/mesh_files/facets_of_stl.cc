// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/facet_mesh.h>
#include <signorini/mesh_files/mesh_text.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace signorini
{
  namespace
  {
    constexpr std::size_t stl_header = 84, stl_facet = 50; ///< bytes, of the binary format

    /** The number of facets that a binary file announces behind its 80 bytes of text. */
    std::size_t announced_facets(const std::string &content)
    {
      std::uint32_t n = 0;
      if (content.size() >= stl_header)
        std::memcpy(&n, content.data() + 80, sizeof(n));
      return n;
    }

    void add_triangle(FacetMesh<3> &mesh, const std::array<std::array<double, 3>, 3> &corners)
    {
      const long first = mesh.vertices.size();
      for (const auto &corner : corners)
        {
          for (const double coordinate : corner)
            if (!std::isfinite(coordinate))
              throw MeshFileError("the file is broken: a coordinate of facet "
                                  + std::to_string(mesh.facets.size() + 1) + " is no number. "
                                  + MeshFileError::remedy);
          mesh.vertices.push_back(point_of_file<3>(corner));
        }
      add_polygon(mesh, {first, first + 1, first + 2});
    }

    FacetMesh<3> facets_of_binary_stl(const std::string &content)
    {
      FacetMesh<3> mesh;
      for (std::size_t f = 0; f < announced_facets(content); ++f)
        {
          std::array<std::array<double, 3>, 3> corners;
          for (unsigned int v = 0; v < 3; ++v)
            for (unsigned int c = 0; c < 3; ++c)
              {
                float             number = 0.f;
                const std::size_t word   = 3 + 3 * v + c; // behind the normal
                std::memcpy(&number,
                            content.data() + stl_header + f * stl_facet + sizeof(float) * word,
                            sizeof(float));
                corners[v][c] = number;
              }
          add_triangle(mesh, corners);
        }
      return mesh;
    }
  } // namespace


  FacetMesh<3> facets_of_stl(const std::string &content)
  {
    const std::size_t n = announced_facets(content);
    if (n > 0 && content.size() == stl_header + stl_facet * n)
      return facets_of_binary_stl(content);
    if (content.compare(0, 5, "solid") != 0 || content.find('\0') != std::string::npos)
      throw MeshFileError("the file is broken: it is neither an STL text, which begins with "
                          "`solid`, nor a binary STL file of the length that it announces ("
                          + std::to_string(n) + " facets). " + MeshFileError::remedy);
    FacetMesh<3>                         mesh;
    std::array<std::array<double, 3>, 3> corners;
    unsigned int                         n_corners = 0;
    std::istringstream                   in(content);
    for (std::string word; in >> word;)
      if (word == "vertex")
        {
          auto &corner = corners[n_corners++ % 3];
          if (!(in >> corner[0] >> corner[1] >> corner[2]))
            throw MeshFileError("the file is broken: vertex " + std::to_string(n_corners)
                                + " has no three coordinates. " + MeshFileError::remedy);
          if (n_corners % 3 == 0)
            add_triangle(mesh, corners);
        }
    if (n_corners % 3 != 0)
      throw MeshFileError("the file is broken: it ends in the middle of a facet. "
                          + MeshFileError::remedy);
    return mesh;
  }
} // namespace signorini
