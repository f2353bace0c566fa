// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_contact_ahead_h
#define signorini_goals_contact_ahead_h

#include <signorini/adaptivity/distance_indicator.h>
#include <signorini/discretization/mesh.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace signorini
{
  /**
   * Up to which level cells are refined that are about to touch something. How close they are is
   * told by distance/gap, see DistanceIndicator.
   */
  struct ContactAhead
  {
    double                    distance; ///< what is closer is about to touch; 0: nothing
    std::vector<unsigned int> levels;   ///< of bodies
    /** Closeness from which on cells are refined together with those that are too close. */
    double far_enough = DistanceIndicator<2>::far_enough;
    /**
     * Closeness counts so many times more for each level that a cell lacks: levels grow towards
     * contact, and where it travels one change of the mesh does for all.
     */
    double grading = 1.;

    /** Levels that a cell lacks. */
    template <typename Cell>
    unsigned int lacking(const Cell &cell) const
    {
      return std::max(0, static_cast<int>(levels[cell->material_id()]) - cell->level());
    }

    /** Closeness as it counts for a cell that lacks some levels. */
    double weigh(const double closeness, const unsigned int lacking) const
    {
      return closeness * std::pow(grading, std::min(lacking, most_lacking));
    }

    /** Below it, closeness counts for nothing. */
    double least_closeness() const { return far_enough / std::pow(grading, most_lacking); }

  private:
    /** Levels that count: cells far away need not be looked at. */
    static constexpr unsigned int most_lacking = 4;
  };

  /**
   * Contact that grows or travels meets cells as fine as the finest that are in contact.
   * Collective. @param in_contact cells of this process by active_cell_index
   */
  template <int dim>
  ContactAhead contact_ahead(const Mesh<dim> &mesh, const std::vector<bool> &in_contact);
} // namespace signorini

#endif
