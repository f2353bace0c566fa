// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_contact_zones_h
#define signorini_goals_contact_zones_h

#include <signorini/discretization/mesh.h>

namespace signorini
{
  /** Where each body is in contact, and how large that place is. */
  template <int dim>
  class ContactZones
  {
  public:
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    /** Collective. @param in_contact see cells(); has to live as long */
    ContactZones(const Mesh<dim> &mesh, const std::vector<bool> &in_contact);

    /** Those that are in contact, of this process by active_cell_index. */
    const std::vector<bool> &cells() const { return in_contact; }

    bool   touches(const unsigned int body) const { return volumes[body] > 0.; }
    double size(const unsigned int body) const { return sizes[body]; }

    /**
     * Whether a cell is farther from the contact of its body than a few times its size, or its body
     * is not in contact. Near contact the body is deformed as at rest; farther away there are
     * waves.
     */
    bool is_far(const Cell &cell) const
    {
      return !touches(cell->material_id())
             || distance(cell) > of_distances * far_away * sizes[cell->material_id()];
    }

  private:
    /** Measured, on discs and balls that hit a plane fast and slowly (doc/adaptivity.md). */
    static constexpr double far_away = 4.;
    /** On regular meshes distances are often equal; then no round-off decides. */
    static constexpr double of_distances = 1. + 1e-9;

    const std::vector<bool>        &in_contact;
    std::vector<dealii::Point<dim>> centres;
    std::vector<double>             volumes; ///< of cells in contact
    std::vector<double>             sizes;   ///< the largest distance of one of them

    /** From the centre of a cell to that of the contact of its body, which touches something. */
    double distance(const Cell &cell) const
    {
      return cell->center().distance(centres[cell->material_id()]);
    }
  };
} // namespace signorini

#endif
