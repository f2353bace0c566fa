// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/cube_mesh.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /**
     * The vertices of the cubes: corners, and the middles of edges, faces and cells. With w for a
     * weight of the edges of a face or cell, its middle is that of the curve of second order: the
     * mean of the corners, and w times what the nodes in the middle of edges lie aside.
     */
    template <int dim>
    class CubeVertices
    {
    public:
      explicit CubeVertices(const MeshContent &content)
        : content(content)
        , of_corner(content.points.size(), std::numeric_limits<unsigned int>::max())
      {
      }

      unsigned int corner(unsigned int point);
      unsigned int middle(unsigned int first, unsigned int second);
      /** Of the face that has these corners, around it. */
      unsigned int face(const std::vector<unsigned int> &around);
      unsigned int cell(const MeshElement &cell);

      std::vector<Point<dim>> points;

    private:
      unsigned int add(const Point<3> &point);
      Tensor<1, 3> aside(unsigned int first, unsigned int second) const;

      const MeshContent                            &content;
      std::vector<unsigned int>                     of_corner;
      std::map<CellShape::Edge, unsigned int>       of_edge;
      std::map<std::vector<unsigned int>, unsigned> of_face;
    };


    template <int dim>
    unsigned int CubeVertices<dim>::add(const Point<3> &point)
    {
      points.emplace_back();
      for (unsigned int d = 0; d < dim; ++d)
        points.back()[d] = point[d];
      return points.size() - 1;
    }


    template <int dim>
    unsigned int CubeVertices<dim>::corner(const unsigned int point)
    {
      if (of_corner[point] == std::numeric_limits<unsigned int>::max())
        of_corner[point] = add(content.points[point]);
      return of_corner[point];
    }


    /** From the middle of the straight edge to the node in the middle. */
    template <int dim>
    Tensor<1, 3> CubeVertices<dim>::aside(const unsigned int first, const unsigned int second) const
    {
      const auto found =
        content.middles.find(CellShape::Edge(std::min(first, second), std::max(first, second)));
      if (found == content.middles.end())
        return {};
      return content.points[found->second]
             - (content.points[first] + .5 * (content.points[second] - content.points[first]));
    }


    template <int dim>
    unsigned int CubeVertices<dim>::middle(const unsigned int first, const unsigned int second)
    {
      const CellShape::Edge ends(std::min(first, second), std::max(first, second));
      const auto            known = of_edge.find(ends);
      if (known != of_edge.end())
        return known->second;
      const Point<3> &start = content.points[ends.first], &end = content.points[ends.second];
      return of_edge[ends] = add(start + (.5 * (end - start) + aside(ends.first, ends.second)));
    }


    template <int dim>
    unsigned int CubeVertices<dim>::face(const std::vector<unsigned int> &around)
    {
      std::vector<unsigned int> key = around;
      std::sort(key.begin(), key.end());
      const auto known = of_face.find(key);
      if (known != of_face.end())
        return known->second;
      const double weight = (around.size() == 3 ? 4. / 9. : 1. / 2.);
      Point<3>     middle;
      for (std::size_t v = 0; v < around.size(); ++v)
        middle += content.points[around[v]] / static_cast<double>(around.size())
                  + weight * aside(around[v], around[(v + 1) % around.size()]);
      return of_face[key] = add(middle);
    }


    template <int dim>
    unsigned int CubeVertices<dim>::cell(const MeshElement &cell)
    {
      const CellShape &shape = shape_of(cell.kind);
      Point<3>         middle;
      for (unsigned int v = 0; v < shape.n_corners; ++v)
        middle += content.points[cell.corners[v]] / static_cast<double>(shape.n_corners);
      for (const CellShape::Edge &edge : shape.edges)
        {
          const bool   is_upright = edge.first % 3 == edge.second % 3; // of a wedge
          const double weight     = cell.kind != CellKind::wedge ? 1. / 4.
                                    : is_upright                 ? 1. / 3.
                                                                 : 2. / 9.;
          middle += weight * aside(cell.corners[edge.first], cell.corners[edge.second]);
        }
      return add(middle);
    }


    /** The points at some corners of a cell. */
    std::vector<unsigned int> points_at(const MeshElement               &cell,
                                        const std::vector<unsigned int> &corners)
    {
      std::vector<unsigned int> points;
      for (const unsigned int v : corners)
        points.push_back(cell.corners[v]);
      return points;
    }


    /** Around the face of a cell that has three of its corners. */
    std::vector<unsigned int> face_with(const MeshElement                 &cell,
                                        const std::array<unsigned int, 3> &three)
    {
      const auto &faces = shape_of(cell.kind).faces;
      return points_at(cell, *std::find_if(faces.begin(), faces.end(), [&](const auto &face) {
                         return std::all_of(three.begin(), three.end(), [&](const unsigned int v) {
                           return std::find(face.begin(), face.end(), v) != face.end();
                         });
                       }));
    }


    /** The cube at a corner of a cell whose middle is given. */
    template <int dim>
    dealii::CellData<dim> cube_at(const MeshElement &cell,
                                  const unsigned int v,
                                  const unsigned int middle,
                                  CubeVertices<dim> &vertices)
    {
      const auto           &ends = shape_of(cell.kind).neighbours[v];
      const unsigned int    a = ends[0], b = ends[1];
      const auto            corner = [&](const unsigned int k) { return cell.corners[k]; };
      dealii::CellData<dim> cube;
      cube.vertices[0] = vertices.corner(corner(v));
      cube.vertices[1] = vertices.middle(corner(v), corner(a));
      cube.vertices[2] = vertices.middle(corner(v), corner(b));
      if constexpr (dim == 2)
        cube.vertices[3] = middle;
      else
        {
          cube.vertices[3]     = vertices.face(face_with(cell, {{v, a, b}}));
          const unsigned int c = ends[2];
          cube.vertices[4]     = vertices.middle(corner(v), corner(c));
          cube.vertices[5]     = vertices.face(face_with(cell, {{v, a, c}}));
          cube.vertices[6]     = vertices.face(face_with(cell, {{v, b, c}}));
          cube.vertices[7]     = middle;
        }
      return cube;
    }


    /** The parts of a face at its corners. */
    template <int dim>
    void split_face(const std::vector<unsigned int> &around,
                    const dealii::types::boundary_id id,
                    CubeVertices<dim>               &vertices,
                    dealii::SubCellData             &faces)
    {
      const std::size_t n = around.size();
      for (std::size_t v = 0; v < n; ++v)
        if constexpr (dim == 2)
          {
            auto &line       = faces.boundary_lines.emplace_back(2);
            line.vertices    = {vertices.corner(around[v]), vertices.middle(around[0], around[1])};
            line.boundary_id = id;
          }
        else
          {
            auto &quad       = faces.boundary_quads.emplace_back(4);
            quad.vertices    = {vertices.corner(around[v]),
                                vertices.middle(around[v], around[(v + 1) % n]),
                                vertices.middle(around[v], around[(v + n - 1) % n]),
                                vertices.face(around)};
            quad.boundary_id = id;
          }
    }
  } // namespace


  template <int dim>
  CubeMesh<dim>
  split_into_cubes(const MeshContent &content, const MeshPart &part, const MeshBoundary &boundary)
  {
    CubeMesh<dim>     mesh;
    CubeVertices<dim> vertices(content);
    for (unsigned int c = 0; c < part.cells.size(); ++c)
      {
        const MeshElement              &cell  = part.cells[c];
        const CellShape                &shape = shape_of(cell.kind);
        const std::vector<unsigned int> all(cell.corners.begin(),
                                            cell.corners.begin() + shape.n_corners);
        const unsigned int middle = dim == 3 ? vertices.cell(cell) : vertices.face(all);
        for (unsigned int v = 0; v < shape.n_corners; ++v)
          {
            mesh.cells.push_back(cube_at(cell, v, middle, vertices));
            mesh.origins.push_back(c);
          }
      }
    for (std::size_t k = 0; k < boundary.faces.size(); ++k)
      if (boundary.ids[k] != 0)
        {
          const MeshElement &cell = part.cells[boundary.faces[k].cell];
          split_face(points_at(cell, shape_of(cell.kind).faces[boundary.faces[k].face]),
                     boundary.ids[k],
                     vertices,
                     mesh.faces);
        }
    mesh.points = std::move(vertices.points);
    return mesh;
  }


  template CubeMesh<2>
  split_into_cubes(const MeshContent &, const MeshPart &, const MeshBoundary &);
  template CubeMesh<3>
  split_into_cubes(const MeshContent &, const MeshPart &, const MeshBoundary &);
} // namespace signorini
