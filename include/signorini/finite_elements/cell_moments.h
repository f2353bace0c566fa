// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_cell_moments_h
#define signorini_finite_elements_cell_moments_h

#include <signorini/discretization/discretization.h>

namespace signorini
{
  /** dim numbers per vertex of a cell: values of a Q1 function, or its moments. */
  using VertexValues = std::vector<double>;

  // Moments of a function on a cell against the functions of a cell, as integrals over the smaller
  // one: the same cell, or a cell and its child, in any order. The cells need not be active.
  // Between a cell and its child they are right only if the child is a part of the map of its
  // parent, as on meshes that change, see MeshGeometry.

  /** int rho v.phi: what a cell contributes to M v. */
  template <int dim>
  VertexValues mass_moments(const Discretization<dim> &discretization,
                            const typename dealii::Triangulation<dim>::cell_iterator &of,
                            const VertexValues                                       &values,
                            const typename dealii::Triangulation<dim>::cell_iterator &against);

  /**
   * int sigma(u) : eps(phi), stress and strain as the elements of the cells make them: what a cell
   * contributes to A u.
   */
  template <int dim>
  VertexValues stiffness_moments(const Discretization<dim> &discretization,
                                 const typename dealii::Triangulation<dim>::cell_iterator &of,
                                 const VertexValues                                       &values,
                                 const typename dealii::Triangulation<dim>::cell_iterator &against);
} // namespace signorini

#endif
