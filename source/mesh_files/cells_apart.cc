// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/cube_mesh.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace signorini
{
  using dealii::BoundingBox;
  using dealii::Point;

  namespace
  {
    /** Parts of the size of a cell by which a point has to be inside. */
    constexpr double depth = 1e-3;


    Point<3> middle_of(const std::vector<Point<3>> &points, const MeshElement &cell)
    {
      const unsigned int n_corners = shape_of(cell.kind).n_corners;
      Point<3>           middle;
      for (unsigned int v = 0; v < n_corners; ++v)
        middle += points[cell.corners[v]] / static_cast<double>(n_corners);
      return middle;
    }


    BoundingBox<3> box_of(const std::vector<Point<3>> &points, const MeshElement &cell)
    {
      std::vector<Point<3>> corners;
      for (unsigned int v = 0; v < shape_of(cell.kind).n_corners; ++v)
        corners.push_back(points[cell.corners[v]]);
      return BoundingBox<3>(corners);
    }


    /** Whether a point is behind all faces of a cell, each cut into triangles (2d: edges). */
    bool
    is_inside(const std::vector<Point<3>> &points, const MeshElement &cell, const Point<3> &point)
    {
      const CellShape &shape     = shape_of(cell.kind);
      const auto       at        = [&](const unsigned int v) { return points[cell.corners[v]]; };
      const auto       is_behind = [&](const dealii::Tensor<1, 3> &inward, const Point<3> &corner) {
        return inward * (point - corner) > depth * inward.norm() * (point - corner).norm();
      };
      return std::all_of(shape.faces.begin(), shape.faces.end(), [&](const auto &face) {
        if (shape.dim == 2)
          {
            const dealii::Tensor<1, 3> along = at(face[1]) - at(face[0]);
            return is_behind(dealii::Tensor<1, 3>({-along[1], along[0], 0.}), at(face[0]));
          }
        for (std::size_t v = 1; v + 1 < face.size(); ++v)
          if (!is_behind(
                dealii::cross_product_3d(at(face[v]) - at(face[0]), at(face[v + 1]) - at(face[0])),
                at(face[0])))
            return false;
        return true;
      });
    }
  } // namespace


  void check_that_cells_are_apart(const std::vector<Point<3>> &points, const MeshPart &part)
  {
    std::vector<BoundingBox<3>> boxes;
    for (const MeshElement &cell : part.cells)
      boxes.push_back(box_of(points, cell));
    const auto tree = dealii::pack_rtree_of_indices(boxes);
    for (std::size_t c = 0; c < part.cells.size(); ++c)
      {
        const Point<3>           middle = middle_of(points, part.cells[c]);
        std::vector<std::size_t> near;
        tree.query(boost::geometry::index::intersects(middle), std::back_inserter(near));
        for (const std::size_t other : near)
          if (other != c && is_inside(points, part.cells[other], middle))
            throw MeshFileError(part.name_of(c) + " and " + part.name_of(other)
                                + " overlap: the middle of the first is in the second. Correct the "
                                  "mesh there; of several bodies in one file each is selected by "
                                  "`Part`.");
      }
  }
} // namespace signorini
