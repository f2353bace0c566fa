// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_cell_moments_h
#define signorini_finite_elements_cell_moments_h

#include <signorini/discretization/discretization.h>

namespace signorini
{
  /** dim numbers per vertex of a cell: values of a Q1 function, or its moments. */
  using VertexValues = std::vector<double>;

  /**
   * Products of a Q1 function on one cell with the shape functions of this cell: what the cell
   * contributes to M v, int rho v.phi. The cell need not be active.
   */
  template <int dim>
  VertexValues mass_moments(const Discretization<dim> &discretization,
                            const typename dealii::Triangulation<dim>::cell_iterator &cell,
                            const VertexValues                                       &values);

  /** What the cell contributes to A u, int sigma(u) : eps(phi). */
  template <int dim>
  VertexValues stiffness_moments(const Discretization<dim> &discretization,
                                 const typename dealii::Triangulation<dim>::cell_iterator &cell,
                                 const VertexValues                                       &values);
} // namespace signorini

#endif
