// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/surface_face.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  std::array<double, SurfaceFace<dim>::n_vertices>
  SurfaceFace<dim>::shape_values(const Point<dim - 1> &xi)
  {
    if constexpr (dim == 2)
      return {{1. - xi[0], xi[0]}};
    else
      return {
        {(1. - xi[0]) * (1. - xi[1]), xi[0] * (1. - xi[1]), (1. - xi[0]) * xi[1], xi[0] * xi[1]}};
  }


  template <int dim>
  Point<dim> SurfaceFace<dim>::position(const Point<dim - 1> &xi) const
  {
    const auto values = shape_values(xi);
    Point<dim> result;
    for (unsigned int v = 0; v < n_vertices; ++v)
      result += values[v] * vertices[v];
    return result;
  }


  template <int dim>
  std::array<Tensor<1, dim>, dim - 1>
  SurfaceFace<dim>::tangents([[maybe_unused]] const Point<dim - 1> &xi) const
  {
    if constexpr (dim == 2)
      return {{vertices[1] - vertices[0]}};
    else
      return {{(1. - xi[1]) * (vertices[1] - vertices[0]) + xi[1] * (vertices[3] - vertices[2]),
               (1. - xi[0]) * (vertices[2] - vertices[0]) + xi[0] * (vertices[3] - vertices[1])}};
  }


  template <int dim>
  Tensor<1, dim> SurfaceFace<dim>::area_vector(const Point<dim - 1> &xi) const
  {
    const auto t = tangents(xi);
    if constexpr (dim == 2)
      return orientation * cross_product_2d(t[0]);
    else
      return orientation * cross_product_3d(t[0], t[1]);
  }


  template <int dim>
  std::array<Tensor<1, dim>, dim> SurfaceFace<dim>::area_vector_parts() const
  {
    const Tensor<1, dim> s = vertices[1] - vertices[0];
    if constexpr (dim == 2)
      return {{orientation * cross_product_2d(s), Tensor<1, 2>()}};
    else
      {
        const Tensor<1, 3> t = vertices[2] - vertices[0], bend = (vertices[3] - vertices[2]) - s;
        return {{orientation * cross_product_3d(s, t),
                 orientation * cross_product_3d(s, bend),
                 orientation * cross_product_3d(bend, t)}};
      }
  }


  template <int dim>
  Point<dim - 1> SurfaceFace<dim>::middle()
  {
    Point<dim - 1> result;
    for (unsigned int d = 0; d < dim - 1; ++d)
      result[d] = 0.5;
    return result;
  }


  template <int dim>
  Tensor<1, dim> SurfaceFace<dim>::unit_normal(const Point<dim - 1> &xi) const
  {
    const Tensor<1, dim> normal = area_vector(xi);
    return normal / normal.norm();
  }


  template <int dim>
  double SurfaceFace<dim>::diameter() const
  {
    double square = 0.;
    for (unsigned int a = 0; a < n_vertices; ++a)
      for (unsigned int b = 0; b < a; ++b)
        square = std::max(square, vertices[a].distance_square(vertices[b]));
    return std::sqrt(square);
  }


  template <int dim>
  BoundingBox<dim> SurfaceFace<dim>::bounding_box() const
  {
    std::pair<Point<dim>, Point<dim>> corners(vertices[0], vertices[0]);
    for (const Point<dim> &vertex : vertices)
      for (unsigned int c = 0; c < dim; ++c)
        {
          corners.first[c]  = std::min(corners.first[c], vertex[c]);
          corners.second[c] = std::max(corners.second[c], vertex[c]);
        }
    return BoundingBox<dim>(corners);
  }


  template <int dim>
  bool is_surface_face(const typename DoFHandler<dim>::active_cell_iterator &cell,
                       const unsigned int                                    face,
                       const unsigned int                                    body,
                       const std::vector<types::boundary_id>                &ids)
  {
    return cell->is_locally_owned() && cell->material_id() == body
           && cell->face(face)->at_boundary()
           && (ids.empty()
               || std::find(ids.begin(), ids.end(), cell->face(face)->boundary_id()) != ids.end());
  }


  template <int dim>
  std::vector<SurfaceFace<dim>>
  owned_surface_faces(const Discretization<dim>             &discretization,
                      const unsigned int                     body,
                      const std::vector<types::boundary_id> &boundary_ids)
  {
    const auto                   &constraints = discretization.hanging_node_constraints();
    std::vector<SurfaceFace<dim>> faces;
    for (const auto &cell : discretization.cells())
      for (const unsigned int f : cell->face_indices())
        {
          if (!is_surface_face<dim>(cell, f, body, boundary_ids))
            continue;
          const auto       face = cell->face(f);
          SurfaceFace<dim> result;
          for (unsigned int v = 0; v < result.n_vertices; ++v)
            {
              const auto dof     = face->vertex_dof_index(v, 0);
              result.vertices[v] = face->vertex(v);
              if (constraints.is_constrained(dof))
                for (const auto &[parent, weight] : *constraints.get_constraint_entries(dof))
                  result.nodes[v].emplace_back(parent / dim, weight);
              else
                result.nodes[v].emplace_back(dof / dim, 1.);
            }
          if (result.unit_normal() * (result.centre() - cell->center()) < 0.)
            result.orientation = -1.;
          result.place = result.centre();
          faces.push_back(result);
        }
    return faces;
  }


  template struct SurfaceFace<2>;
  template struct SurfaceFace<3>;
  template bool is_surface_face<2>(const DoFHandler<2>::active_cell_iterator &,
                                   unsigned int,
                                   unsigned int,
                                   const std::vector<types::boundary_id> &);
  template bool is_surface_face<3>(const DoFHandler<3>::active_cell_iterator &,
                                   unsigned int,
                                   unsigned int,
                                   const std::vector<types::boundary_id> &);
  template std::vector<SurfaceFace<2>> owned_surface_faces(const Discretization<2> &,
                                                           unsigned int,
                                                           const std::vector<types::boundary_id> &);
  template std::vector<SurfaceFace<3>> owned_surface_faces(const Discretization<3> &,
                                                           unsigned int,
                                                           const std::vector<types::boundary_id> &);
} // namespace signorini
