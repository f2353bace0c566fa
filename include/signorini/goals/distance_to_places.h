// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_distance_to_places_h
#define signorini_goals_distance_to_places_h

#include <signorini/discretization/mesh.h>

#include <deal.II/numerics/rtree.h>

namespace signorini
{
  /**
   * Distances from the centres of cells to those of marked cells of the same body, on whichever
   * process they are. Every process knows the centres of all marked cells: of a surface, not of the
   * volume.
   */
  template <int dim>
  class DistanceToPlaces
  {
  public:
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    /** Collective. @param marked cells of this process by active_cell_index */
    DistanceToPlaces(const Mesh<dim> &mesh, const std::vector<bool> &marked);

    /** Infinite if no cell of the body is marked. */
    double operator()(const Cell &cell) const;

  private:
    std::vector<dealii::RTree<dealii::Point<dim>>> centres; ///< by body
  };
} // namespace signorini

#endif
