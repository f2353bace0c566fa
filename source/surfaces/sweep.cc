// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/sweep.h>

#include <boost/geometry/index/predicates.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  Sweep<dim>::Sweep(const SurfaceFace<dim> &face,
                    const BoundingBox<dim> &slave_body,
                    const BoundingBox<dim> &master_body)
    : normal(face.unit_normal())
    , centre(face.centre())
    , box_of_face(face.bounding_box())
    , diameter(face.diameter())
  {
    for (unsigned int c = 0; c < dim; ++c)
      behind +=
        0.25 * std::abs(normal[c]) * (slave_body.side_length(c) + master_body.side_length(c));
    for (unsigned int corner = 0; corner < GeometryInfo<dim>::vertices_per_cell; ++corner)
      for (const Point<dim> &vertex : face.vertices)
        ahead = std::max(ahead, normal * (master_body.vertex(corner) - vertex));
    measure(face);
  }


  template <int dim>
  Sweep<dim>::Sweep(const SurfaceFace<dim> &face, const double behind, const double ahead)
    : normal(face.unit_normal())
    , centre(face.centre())
    , box_of_face(face.bounding_box())
    , diameter(face.diameter())
    , behind(behind)
    , ahead(ahead)
  {
    measure(face);
  }


  template <int dim>
  void Sweep<dim>::measure(const SurfaceFace<dim> &face)
  {
    std::array<double, dim> parts;
    for (unsigned int c = 0; c < dim; ++c)
      parts[c] = std::abs(normal[c]);
    std::sort(parts.begin(), parts.end());
    obliquity = parts[dim - 2]; // along an axis a box fits, however long it is
    for (const Point<dim> &vertex : face.vertices)
      warp = std::max(warp, std::abs(normal * (vertex - centre)));
  }


  template <int dim>
  void Sweep<dim>::find(const Tree &tree, std::vector<std::size_t> &found) const
  {
    found.clear();
    search(tree, -behind, ahead, found);
    // Neighbouring parts find the same; the order of sums must not depend on the tree.
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }


  template <int dim>
  bool Sweep<dim>::reaches(const SurfaceFace<dim> &master) const
  {
    double lowest = std::numeric_limits<double>::max(), highest = -lowest;
    for (const Point<dim> &vertex : master.vertices)
      {
        const double height = normal * (vertex - centre);
        lowest              = std::min(lowest, height);
        highest             = std::max(highest, height);
      }
    return lowest <= ahead + warp && highest >= -behind - warp;
  }


  template <int dim>
  BoundingBox<dim> Sweep<dim>::box(const double from, const double to) const
  {
    auto [lower, upper] = box_of_face.get_boundary_points();
    for (unsigned int c = 0; c < dim; ++c)
      {
        lower[c] += std::min(from * normal[c], to * normal[c]);
        upper[c] += std::max(from * normal[c], to * normal[c]);
      }
    return BoundingBox<dim>({lower, upper});
  }


  template <int dim>
  void Sweep<dim>::search(const Tree               &tree,
                          const double              from,
                          const double              to,
                          std::vector<std::size_t> &found) const
  {
    // Of a face that is a point, as round-off makes it far away, no part would be slender.
    const double slender = std::max(diameter, 1e-6 * (behind + ahead));
    const auto   in_box  = boost::geometry::index::intersects(box(from, to));
    if (!(obliquity * (to - from) > slender))
      tree.query(in_box, std::back_inserter(found));
    else if (tree.qbegin(in_box) != tree.qend())
      {
        const double middle = 0.5 * (from + to);
        search(tree, from, middle, found);
        search(tree, middle, to, found);
      }
  }


  template class Sweep<2>;
  template class Sweep<3>;
} // namespace signorini
