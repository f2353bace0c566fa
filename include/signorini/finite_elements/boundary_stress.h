// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_boundary_stress_h
#define signorini_finite_elements_boundary_stress_h

#include <signorini/discretization/discretization.h>

namespace signorini
{
  /**
   * The force on each body through those faces of its boundary that bear contact, as the integral
   * of the stress vectors of their cells, with the strain modes of the elements. Only these cells
   * are looked at. First order in the size of the cells, also because the inertia of half a cell
   * lies between the nodes and its points. A force is a linear function of the displacement, which
   * is found where contact comes for the first time, and kept.
   */
  template <int dim>
  class BoundaryStress
  {
  public:
    /** The discretization must outlive the object. */
    explicit BoundaryStress(const Discretization<dim> &discretization);

    /**
     * By bodies, the same on all processes. Collective.
     * @param contact_force nodal forces: a face bears contact if one of its nodes has a force that
     *                      is more than round-off of the largest one
     */
    std::vector<std::array<double, 3>> forces(const Vector &displacement,
                                              const Vector &contact_force);

  private:
    struct BoundaryFace
    {
      typename dealii::DoFHandler<dim>::active_cell_iterator cell;
      unsigned int                                           face;
      std::vector<dealii::Tensor<1, dim>> force_of_dofs; ///< of the cell; empty: not known yet

      dealii::Tensor<1, dim> force_of(const Vector &displacement) const;
    };

    const Discretization<dim> &discretization;
    std::vector<BoundaryFace>  faces; ///< all of owned cells
  };
} // namespace signorini

#endif
