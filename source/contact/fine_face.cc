// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/fine_face.h>

#include <deal.II/grid/manifold.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace signorini
{
  using namespace dealii;


  template <int dim>
  Tensor<1, dim> normal_of_facet(const std::array<Point<dim>, dim> &corners)
  {
    Tensor<1, dim> normal;
    if constexpr (dim == 2)
      normal = cross_product_2d(corners[1] - corners[0]);
    else
      normal = cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
    return normal / normal.norm();
  }


  template <int dim>
  FineFace<dim>::FineFace(const Cell &cell, const unsigned int face)
    : of_cell(cell)
    , number(face)
    , size(cell->face(face)->diameter())
  {
    std::array<Point<dim>, dim> corners;
    for (unsigned int k = 0; k < dim; ++k)
      corners[k] = cell->face(face)->vertex(k);
    is_turned = normal_of_facet<dim>(corners) * (cell->face(face)->center() - cell->center()) < 0.;
  }


  template <int dim>
  std::array<double, FineFace<dim>::n_vertices> FineFace<dim>::weights(const Place &place)
  {
    std::array<double, n_vertices> result;
    for (unsigned int k = 0; k < n_vertices; ++k)
      result[k] = ((k & 1) != 0 ? place[0] : 1. - place[0])
                  * (dim == 2 ? 1. : ((k & 2) != 0 ? place[1] : 1. - place[1]));
    return result;
  }


  template <int dim>
  typename FineFace<dim>::Place FineFace<dim>::place_in_grid(const unsigned int n)
  {
    return {{double(n % (n_parts + 1)) / n_parts, double(n / (n_parts + 1)) / n_parts}};
  }


  template <int dim>
  Tensor<1, dim> FineFace<dim>::displacement_of(const unsigned int vertex,
                                                const Vector      &displacement) const
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = displacement(of_cell->face(number)->vertex_dof_index(vertex, c));
    return result;
  }


  template <int dim>
  std::vector<Point<dim>> FineFace<dim>::vertices(const Vector &displacement) const
  {
    std::vector<Point<dim>> result;
    for (unsigned int k = 0; k < n_vertices; ++k)
      result.push_back(of_cell->face(number)->vertex(k) + displacement_of(k, displacement));
    return result;
  }


  template <int dim>
  bool FineFace<dim>::has_value(const unsigned int vertex, const Vector &values) const
  {
    return displacement_of(vertex, values) != Tensor<1, dim>();
  }


  template <int dim>
  std::array<Tensor<1, dim>, FineFace<dim>::n_vertices>
  FineFace<dim>::displacements(const Vector &displacement) const
  {
    std::array<Tensor<1, dim>, n_vertices> result;
    for (unsigned int k = 0; k < n_vertices; ++k)
      result[k] = displacement_of(k, displacement);
    return result;
  }


  template <int dim>
  Point<dim> FineFace<dim>::middle(const Vector &displacement) const
  {
    Point<dim> result;
    for (const Point<dim> &vertex : vertices(displacement))
      result += 1. / n_vertices * vertex;
    return result;
  }


  template <int dim>
  Point<dim> FineFace<dim>::undeformed(const Place &place) const
  {
    const auto                         face = of_cell->face(number);
    std::array<Point<dim>, n_vertices> corners;
    for (unsigned int k = 0; k < n_vertices; ++k)
      corners[k] = face->vertex(k);
    const auto of_corners = weights(place);
    return face->get_manifold().get_new_point(
      make_array_view(corners.begin(), corners.end()),
      make_array_view(of_corners.begin(), of_corners.end()));
  }


  template <int dim>
  std::vector<Point<dim>> FineFace<dim>::points(const Vector &displacement)
  {
    if (grid.empty())
      for (unsigned int n = 0; n < (n_parts + 1) * (dim == 2 ? 1 : n_parts + 1); ++n)
        grid.push_back(undeformed(place_in_grid(n)));
    const auto              of_vertices = displacements(displacement);
    std::vector<Point<dim>> result      = grid;
    for (unsigned int n = 0; n < result.size(); ++n)
      {
        const auto of_corners = weights(place_in_grid(n));
        for (unsigned int k = 0; k < n_vertices; ++k)
          result[n] += of_corners[k] * of_vertices[k];
      }
    return result;
  }


  template <int dim>
  BoundingBox<dim> FineFace<dim>::box(const Vector &displacement)
  {
    return BoundingBox<dim>(points(displacement));
  }


  template <int dim>
  BoundingBox<dim> FineFace<dim>::wide_box(const Vector &displacement) const
  {
    BoundingBox<dim> result(vertices(displacement));
    result.extend(margin * size);
    return result;
  }


  template <int dim>
  double
  FineFace<dim>::least(const std::function<std::optional<double>(const Point<dim> &)> &function,
                       const Vector                                                   &displacement)
  {
    double     result = std::numeric_limits<double>::infinity();
    Place      best{};
    const auto try_point = [&](const Place &place, const Point<dim> &point) {
      if (const auto value = function(point); value && *value < result)
        {
          result = *value;
          best   = place;
        }
    };
    const std::vector<Point<dim>> all = points(displacement);
    for (unsigned int n = 0; n < all.size(); ++n)
      try_point(place_in_grid(n), all[n]);
    const auto of_vertices = displacements(displacement);
    double     spacing     = 1. / n_parts;
    for (unsigned int look = 0; look < n_closer_looks; ++look)
      {
        spacing /= 2.;
        const Place centre = best;
        for (int j = dim == 2 ? 0 : -1; j <= (dim == 2 ? 0 : 1); ++j)
          for (int i = -1; i <= 1; ++i)
            {
              const Place place{{std::clamp(centre[0] + i * spacing, 0., 1.),
                                 std::clamp(centre[1] + j * spacing, 0., 1.)}};
              Point<dim>  point      = undeformed(place);
              const auto  of_corners = weights(place);
              for (unsigned int k = 0; k < n_vertices; ++k)
                point += of_corners[k] * of_vertices[k];
              try_point(place, point);
            }
      }
    return result;
  }


  template <int dim>
  std::vector<std::array<Point<dim>, dim>> FineFace<dim>::facets(const Vector &displacement)
  {
    const std::vector<Point<dim>>            all = points(displacement);
    std::vector<std::array<Point<dim>, dim>> result;
    for (unsigned int j = 0; j < (dim == 2 ? 1 : n_parts); ++j)
      for (unsigned int i = 0; i < n_parts; ++i)
        {
          const unsigned int first = (n_parts + 1) * j + i, above = first + n_parts + 1;
          if constexpr (dim == 2)
            result.push_back({{all[first], all[first + 1]}});
          else
            {
              result.push_back({{all[first], all[first + 1], all[above]}});
              result.push_back({{all[first + 1], all[above + 1], all[above]}});
            }
        }
    if (is_turned)
      for (auto &corners : result)
        std::swap(corners[0], corners[1]);
    return result;
  }


#define INSTANTIATE(dim)                                                                           \
  template class FineFace<dim>;                                                                    \
  template Tensor<1, dim> normal_of_facet<dim>(const std::array<Point<dim>, dim> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
