// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/cube_mesh.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <sstream>

namespace signorini
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    /** The volume that the edges at a corner span, and the product of their lengths. */
    struct CornerVolume
    {
      double volume, lengths;
    };


    CornerVolume volume_at(const std::vector<Point<3>> &points,
                           const MeshElement           &cell,
                           const unsigned int           corner)
    {
      const CellShape &shape      = shape_of(cell.kind);
      const auto      &neighbours = shape.neighbours[corner];
      const Point<3>  &origin     = points[cell.corners[corner]];
      const auto       edge       = [&](const unsigned int k) {
        return points[cell.corners[neighbours[k]]] - origin;
      };
      const Tensor<1, 3> across = dealii::cross_product_3d(edge(0), edge(1));
      const double       area   = edge(0).norm() * edge(1).norm();
      return shape.dim == 2 ? CornerVolume{across[2], area}
                            : CornerVolume{across * edge(2), area * edge(2).norm()};
    }


    bool is_negative(const std::vector<Point<3>> &points, const MeshElement &cell)
    {
      double sum = 0.;
      for (unsigned int corner = 0; corner < shape_of(cell.kind).n_corners; ++corner)
        sum += volume_at(points, cell, corner).volume;
      return sum < 0.;
    }


    /** List the corners in the other direction of rotation. */
    void turn(MeshElement &cell)
    {
      auto &corners = cell.corners;
      switch (cell.kind)
        {
        case CellKind::triangle:
        case CellKind::tetrahedron:
          std::swap(corners[1], corners[2]);
          break;
        case CellKind::quadrilateral:
          std::swap(corners[1], corners[3]);
          break;
        case CellKind::wedge:
          std::swap_ranges(corners.begin(), corners.begin() + 3, corners.begin() + 3);
          break;
        default:
          std::swap_ranges(corners.begin(), corners.begin() + 4, corners.begin() + 4);
        }
    }


    std::string in_words(const Point<3> &point, const unsigned int dim)
    {
      std::ostringstream text;
      text << '(' << point[0] << ' ' << point[1];
      if (dim == 3)
        text << ' ' << point[2];
      text << ')';
      return text.str();
    }


    [[noreturn]] void
    refuse_corner(const MeshPart &part, const std::size_t c, const Point<3> &point)
    {
      throw MeshFileError(part.name_of(c) + " is inverted or degenerate at its vertex "
                          + in_words(point, shape_of(part.cells[c].kind).dim)
                          + ". Correct the mesh there: no corner may be turned inside out or have "
                            "no volume.");
    }


    [[noreturn]] void
    refuse_minority(const std::vector<Point<3>> &points, const MeshPart &part, const std::size_t c)
    {
      const MeshElement &cell  = part.cells[c];
      const CellShape   &shape = shape_of(cell.kind);
      if (shape.dim == 2)
        refuse_corner(part, c, points[cell.corners[0]]);
      Point<3> centre;
      for (unsigned int v = 0; v < shape.n_corners; ++v)
        centre += points[cell.corners[v]] / static_cast<double>(shape.n_corners);
      throw MeshFileError("cell " + std::to_string(cell.label) + " with the centre "
                          + in_words(centre, 3)
                          + " is inverted: it lists its vertices in the other direction of "
                            "rotation than most cells. Correct the order of its vertices.");
    }
  } // namespace


  void orient_cells(const std::vector<Point<3>> &points, const bool turns_each, MeshPart &part)
  {
    std::vector<bool> negative;
    std::size_t       n_negative = 0;
    for (const MeshElement &cell : part.cells)
      {
        negative.push_back(is_negative(points, cell));
        n_negative += negative.back();
      }
    const bool most_are_negative = 2 * n_negative > part.cells.size();
    for (std::size_t c = 0; c < part.cells.size(); ++c)
      {
        if (!turns_each && negative[c] != most_are_negative)
          refuse_minority(points, part, c);
        if (negative[c])
          turn(part.cells[c]);
      }
    for (std::size_t c = 0; c < part.cells.size(); ++c)
      for (unsigned int v = 0; v < shape_of(part.cells[c].kind).n_corners; ++v)
        if (const CornerVolume corner = volume_at(points, part.cells[c], v);
            !(corner.volume > 1e-10 * corner.lengths))
          refuse_corner(part, c, points[part.cells[c].corners[v]]);
  }
} // namespace signorini
