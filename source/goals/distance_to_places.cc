// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/common_points.h>
#include <signorini/goals/distance_to_places.h>


#include <boost/geometry/index/rtree.hpp>

#include <limits>

namespace signorini
{
  template <int dim>
  DistanceToPlaces<dim>::DistanceToPlaces(const Mesh<dim> &mesh, const std::vector<bool> &marked)
  {
    std::vector<std::vector<dealii::Point<dim>>> own(mesh.bodies().size());
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned() && marked[cell->active_cell_index()])
        own[cell->material_id()].push_back(cell->center());
    for (const auto &of_body : own)
      centres.push_back(dealii::pack_rtree(common_points(of_body, mesh.communicator())));
  }


  template <int dim>
  double DistanceToPlaces<dim>::operator()(const Cell &cell) const
  {
    const auto              &tree   = centres[cell->material_id()];
    const dealii::Point<dim> centre = cell->center();
    for (auto nearest = tree.qbegin(boost::geometry::index::nearest(centre, 1));
         nearest != tree.qend();
         ++nearest)
      return centre.distance(*nearest);
    return std::numeric_limits<double>::infinity();
  }


  template class DistanceToPlaces<2>;
  template class DistanceToPlaces<3>;
} // namespace signorini
