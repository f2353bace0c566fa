// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_obstacles_facets_h
#define signorini_tests_obstacles_facets_h

#include <signorini/obstacles/mesh_obstacle.h>

#include <cmath>
#include <memory>

namespace signorini::tests
{
  /** A closed line through points, counterclockwise. */
  inline FacetMesh<2> polygon(const std::vector<dealii::Point<2>> &points)
  {
    FacetMesh<2> mesh;
    mesh.vertices = points;
    for (unsigned int k = 0; k < points.size(); ++k)
      mesh.facets.push_back({{k, static_cast<unsigned int>((k + 1) % points.size())}});
    return mesh;
  }

  /** A line through points that ends. */
  inline FacetMesh<2> line(const std::vector<dealii::Point<2>> &points)
  {
    FacetMesh<2> mesh = polygon(points);
    mesh.facets.pop_back();
    return mesh;
  }

  /** The surface of a prism: a polygon, counterclockwise, from z = 0 up. */
  inline FacetMesh<3> prism(const std::vector<dealii::Point<2>>            &base,
                            const std::vector<std::array<unsigned int, 3>> &triangles_of_base,
                            const double                                    height)
  {
    FacetMesh<3>       mesh;
    const unsigned int n = base.size();
    for (const double z : {0., height})
      for (const auto &point : base)
        mesh.vertices.emplace_back(point[0], point[1], z);
    for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int next = (k + 1) % n;
        mesh.facets.push_back({{k, next, n + next}});
        mesh.facets.push_back({{k, n + next, n + k}});
      }
    for (const auto &[a, b, c] : triangles_of_base)
      {
        mesh.facets.push_back({{a, c, b}});
        mesh.facets.push_back({{n + a, n + b, n + c}});
      }
    return mesh;
  }

  /** A cuboid from the origin. */
  inline FacetMesh<3> cuboid(const double x, const double y, const double z)
  {
    return prism({{0., 0.}, {x, 0.}, {x, y}, {0., y}}, {{{0, 1, 2}}, {{0, 2, 3}}}, z);
  }

  /** The unit sphere in n circles of latitude with 2 n points each. */
  inline FacetMesh<3> globe(const unsigned int n)
  {
    FacetMesh<3>       mesh;
    const unsigned int m = 2 * n;
    mesh.vertices        = {{0., 0., -1.}, {0., 0., 1.}};
    for (unsigned int row = 1; row < n; ++row)
      for (unsigned int k = 0; k < m; ++k)
        {
          const double theta = M_PI * row / n, phi = 2. * M_PI * k / m;
          mesh.vertices.emplace_back(
            std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), -std::cos(theta));
        }
    const auto at = [&](const unsigned int row, const unsigned int k) {
      return row == 0 ? 0 : row == n ? 1 : 2 + (row - 1) * m + k % m;
    };
    for (unsigned int row = 0; row < n; ++row)
      for (unsigned int k = 0; k < m; ++k)
        {
          if (row > 0)
            mesh.facets.push_back({{at(row, k), at(row, k + 1), at(row + 1, k)}});
          if (row + 1 < n)
            mesh.facets.push_back({{at(row, k + 1), at(row + 1, k + 1), at(row + 1, k)}});
        }
    return mesh;
  }

  template <int dim>
  MeshObstacle<dim> obstacle_of(const FacetMesh<dim> &mesh, const bool open = false)
  {
    return {std::make_shared<FacetedSurface<dim>>(mesh, open)};
  }
} // namespace signorini::tests

#endif
