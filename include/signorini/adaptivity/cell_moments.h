// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_cell_moments_h
#define signorini_adaptivity_cell_moments_h

#include <signorini/discretization/discretization.h>

#include <deal.II/fe/fe_values.h>

namespace signorini
{
  /**
   * Products of a Q1 function on one cell with the shape functions of this cell, by the quadrature of the matrices: what the cell would contribute to M v
   * or A u. Values and moments have dim numbers per vertex.
   */
  template <int dim>
  class CellMoments
  {
  public:
    using Values = std::vector<double>;
    using Cell   = typename dealii::Triangulation<dim>::cell_iterator;

    explicit CellMoments(const Discretization<dim> &discretization);

    /** int rho v.phi. */
    Values of_mass(const Cell &cell, const Values &values);

    /** int sigma(u) : eps(phi). */
    Values of_stiffness(const Cell &cell, const Values &values);

  private:
    const Scene<dim>       &scene;
    const dealii::FE_Q<dim> scalar_fe;
    dealii::FEValues<dim>   fe_values;
  };
} // namespace signorini

#endif
