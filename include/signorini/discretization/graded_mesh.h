// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_graded_mesh_h
#define signorini_discretization_graded_mesh_h

#include <signorini/discretization/mesh.h>

namespace signorini
{
  /**
   * What iterations feel of the Courant number. Where only a few cells of a body are small, a wave
   * has left them long before the end of a step: this is the number of half of its cells, or if it
   * is larger the largest C that is the number of so many cells, and of smaller ones, that they
   * would fill a cube (square) with C/3 cells at an edge; the largest of all bodies. On uniform
   * meshes it is the Courant number. Collective.
   */
  template <int dim>
  double effective_courant_number(const Mesh<dim> &mesh, double step_size);

  /** Share of the cells that have not the level of most cells of their body. Collective. */
  template <int dim>
  double grading(const Mesh<dim> &mesh);
} // namespace signorini

#endif
