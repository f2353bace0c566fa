// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/cube_mesh.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace signorini
{
  using dealii::Point;

  namespace
  {
    /** Corners around bottom and top, as deal.II counts vertices; swaps twice is the identity. */
    constexpr unsigned int corner_of_vertex[] = {0, 1, 3, 2, 4, 5, 7, 6};


    /** A face with its boundary id. */
    template <int dim>
    void add_face(const std::vector<unsigned int> &around,
                  const dealii::types::boundary_id id,
                  dealii::SubCellData             &faces)
    {
      const auto fill = [&](auto &face) {
        for (std::size_t v = 0; v < around.size(); ++v)
          face.vertices[v] = around[corner_of_vertex[v]];
        face.boundary_id = id;
      };
      if constexpr (dim == 2)
        fill(faces.boundary_lines.emplace_back(2));
      else
        fill(faces.boundary_quads.emplace_back(4));
    }
  } // namespace


  template <int dim>
  CubeMesh<dim>
  cubes_of(const MeshContent &content, const MeshPart &part, const MeshBoundary &boundary)
  {
    constexpr unsigned int    unused = std::numeric_limits<unsigned int>::max();
    std::vector<unsigned int> new_index(content.points.size(), unused);
    for (const MeshElement &cell : part.cells)
      for (unsigned int v = 0; v < (1u << dim); ++v)
        new_index[cell.corners[v]] = 0;
    CubeMesh<dim> mesh;
    for (std::size_t p = 0; p < content.points.size(); ++p)
      if (new_index[p] != unused)
        {
          new_index[p] = mesh.points.size();
          mesh.points.emplace_back();
          for (unsigned int d = 0; d < dim; ++d)
            mesh.points.back()[d] = content.points[p][d];
        }
    for (const MeshElement &cell : part.cells)
      {
        mesh.origins.push_back(mesh.cells.size());
        mesh.cells.emplace_back();
        for (unsigned int v = 0; v < (1u << dim); ++v)
          mesh.cells.back().vertices[v] = new_index[cell.corners[corner_of_vertex[v]]];
      }
    for (std::size_t k = 0; k < boundary.faces.size(); ++k)
      if (boundary.ids[k] != 0)
        {
          const MeshElement        &cell = part.cells[boundary.faces[k].cell];
          std::vector<unsigned int> around;
          for (const unsigned int v : shape_of(cell.kind).faces[boundary.faces[k].face])
            around.push_back(new_index[cell.corners[v]]);
          add_face<dim>(around, boundary.ids[k], mesh.faces);
        }
    return mesh;
  }


  template <int dim>
  double smallest_jacobian(const CubeMesh<dim> &mesh, const MeshPart &part)
  {
    double smallest = 1.;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (unsigned int v = 0; v < (1u << dim); ++v)
        {
          // The edges that meet in the vertex, as columns: derivatives of the mapping there.
          const auto            &vertices = mesh.cells[c].vertices;
          dealii::Tensor<2, dim> jacobian;
          double                 lengths = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int           bit = 1u << d;
              const dealii::Tensor<1, dim> edge =
                mesh.points[vertices[v | bit]] - mesh.points[vertices[v & ~bit]];
              lengths *= edge.norm();
              for (unsigned int row = 0; row < dim; ++row)
                jacobian[row][d] = edge[row];
            }
          const double scaled = determinant(jacobian) / lengths;
          if (!(scaled > 1e-10))
            {
              std::ostringstream place;
              place << mesh.points[vertices[v]];
              throw MeshFileError(part.name_of(mesh.origins[c]) + " is inverted or degenerate at ("
                                  + place.str()
                                  + "), where it is cut into cubes. Correct the mesh there; nodes "
                                    "in the middle of edges may lie too far aside.");
            }
          smallest = std::min(smallest, scaled);
        }
    return smallest;
  }


#define INSTANTIATE(dim)                                                                           \
  template CubeMesh<dim> cubes_of(const MeshContent &, const MeshPart &, const MeshBoundary &);    \
  template double        smallest_jacobian(const CubeMesh<dim> &, const MeshPart &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
