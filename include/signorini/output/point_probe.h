// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_point_probe_h
#define signorini_output_point_probe_h

#include <signorini/discretization/discretization.h>
#include <signorini/model/point_probe.h>

namespace signorini
{
  /** What happens at a material point. */
  struct PointReading
  {
    std::array<double, 3> position{}; ///< where the point is now
    std::array<double, 3> displacement{}, velocity{};
    std::array<double, 6> stress{}; ///< xx, yy, zz, xy, xz, yz
    double                von_mises = 0.;
  };

  /**
   * A point of a body, on whichever process it lives. Where cells meet, the stress is that of one
   * of them, the same on any number of processes.
   */
  template <int dim>
  class PointProbe
  {
  public:
    /**
     * Finds the cell of the point. A little outside, as a point of a round surface is with respect
     * to the facets of the mesh, the nearest point of a cell takes its place. Collective.
     * @throws UserError if the point is not in the body
     */
    PointProbe(const PointProbeDescription<dim> &description,
               const Discretization<dim>        &discretization);

    /**
     * The reading, on all processes. Collective.
     * @param displacement, velocity with ghosts and hanging nodes
     */
    PointReading read(const Vector &displacement, const Vector &velocity) const;

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    const Discretization<dim> &discretization;
    unsigned int               owner = 0; ///< process with the cell
    Cell                       cell;      ///< there
    dealii::Point<dim>         place;     ///< in the reference cell

    /**
     * The nearest owned cell of the body, and how far outside of it the point is: in cells, and in
     * those of the first mesh where they have been refined since.
     */
    double find_cell(const PointProbeDescription<dim> &description);

    /** With the strain modes of the element. */
    dealii::SymmetricTensor<2, dim> strain(const Vector &displacement) const;
  };
} // namespace signorini

#endif
