// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/contact_frame.h>
#include <signorini/surfaces/projected_face.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  FacePlane<dim>::FacePlane(const SurfaceFace<dim> &face)
    : origin(face.centre())
    , normal(face.unit_normal())
  {
    const auto frame = contact_frame<dim>(normal);
    for (unsigned int d = 0; d < dim - 1; ++d)
      for (unsigned int c = 0; c < dim; ++c)
        axes[d][c] = frame[dim * (d + 1) + c];
  }


  template <int dim>
  ProjectedFace<dim>::ProjectedFace(const SurfaceFace<dim> &face, const FacePlane<dim> &plane)
  {
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        const Tensor<1, dim> from_origin = face.vertices[v] - plane.origin;
        vertices[v]                      = plane.project(from_origin);
        heights[v]                       = plane.normal * from_origin;
      }
    lower = upper = vertices[0];
    for (unsigned int v = 1; v < n_vertices; ++v)
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          lower[d] = std::min(lower[d], vertices[v][d]);
          upper[d] = std::max(upper[d], vertices[v][d]);
        }
  }


  template <int dim>
  Outline<dim> ProjectedFace<dim>::outline() const
  {
    Outline<dim> points(vertices.begin(), vertices.end());
    if constexpr (dim == 2)
      {
        if (points[1][0] < points[0][0])
          std::swap(points[0], points[1]);
      }
    else
      {
        std::swap(points[2], points[3]); // lexicographic to circular
        if (area(points) < 0.)
          std::reverse(points.begin(), points.end());
      }
    return points;
  }


  template <int dim>
  bool ProjectedFace<dim>::may_overlap(const ProjectedFace &other) const
  {
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (upper[d] <= other.lower[d] || other.upper[d] <= lower[d])
        return false;
    return true;
  }


  template <int dim>
  void ProjectedFace<dim>::prepare(const SurfaceFace<dim> &face)
  {
    area_parts = face.area_vector_parts();
    edges[0]   = vertices[1] - vertices[0];
    if constexpr (dim == 3)
      {
        edges[1]                 = vertices[2] - vertices[0];
        edges[2]                 = (vertices[3] - vertices[2]) - edges[0];
        const auto &[a, b, bend] = edges;
        double smallest          = std::numeric_limits<double>::max();
        for (const double xi : {0., 1.})
          for (const double eta : {0., 1.})
            {
              const Tensor<1, 2> along = a + eta * bend, across = b + xi * bend;
              smallest = std::min(smallest, std::abs(along[0] * across[1] - along[1] * across[0]));
            }
        remainder = bend.norm() * (a.norm() + b.norm() + bend.norm()) / smallest;
      }
  }


  template <int dim>
  LanePoint<dim> ProjectedFace<dim>::map_back(const LanePoint<dim> &target) const
  {
    if constexpr (dim == 2)
      return {{(target[0] - vertices[0][0]) / edges[0][0]}};
    else
      {
        const auto &[a, b, bend] = edges;
        const AtPoints<3> x = target[0] - vertices[0][0], y = target[1] - vertices[0][1];
        LanePoint<3>      xi{{AtPoints<3>::Constant(0.5), AtPoints<3>::Constant(0.5)}};
        for (unsigned int iteration = 0; iteration < 20; ++iteration)
          {
            const AtPoints<3> s0 = a[0] + xi[1] * bend[0], s1 = a[1] + xi[1] * bend[1],
                              t0 = b[0] + xi[0] * bend[0], t1 = b[1] + xi[0] * bend[1],
                              defect0 = x - xi[0] * s0 - xi[1] * b[0],
                              defect1 = y - xi[0] * s1 - xi[1] * b[1],
                              inverse = 1. / (s0 * t1 - s1 * t0),
                              change0 = (defect0 * t1 - defect1 * t0) * inverse,
                              change1 = (s0 * defect1 - s1 * defect0) * inverse;
            xi[0] += change0;
            xi[1] += change1;
            const double largest = (change0 * change1).abs().maxCoeff();
            if (remainder * largest < 1e-16
                || (change0.square() + change1.square()).maxCoeff() < 1e-28)
              break;
          }
        return xi;
      }
  }


  template <int dim>
  LaneShapes<dim> ProjectedFace<dim>::shape_values(const LanePoint<dim> &xi)
  {
    if constexpr (dim == 2)
      return {{1. - xi[0], xi[0]}};
    else
      {
        const AtPoints<3> a = 1. - xi[0], b = 1. - xi[1];
        return {{a * b, xi[0] * b, a * xi[1], xi[0] * xi[1]}};
      }
  }


  template <int dim>
  std::array<AtPoints<dim>, dim> ProjectedFace<dim>::area_vector(const LanePoint<dim> &xi) const
  {
    std::array<AtPoints<dim>, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      if constexpr (dim == 2)
        result[c] = AtPoints<dim>::Constant(area_parts[0][c]);
      else
        result[c] = area_parts[0][c] + area_parts[1][c] * xi[0] + area_parts[2][c] * xi[1];
    return result;
  }


  template <int dim>
  Tensor<1, dim> ProjectedFace<dim>::area_vector_at_centre() const
  {
    if constexpr (dim == 2)
      return area_parts[0];
    else
      return area_parts[0] + 0.5 * (area_parts[1] + area_parts[2]);
  }


  template struct FacePlane<2>;
  template struct FacePlane<3>;
  template class ProjectedFace<2>;
  template class ProjectedFace<3>;
} // namespace signorini
