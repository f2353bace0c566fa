// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_coarse_mesh_h
#define signorini_discretization_coarse_mesh_h

#include <signorini/model/body_description.h>

#include <deal.II/grid/tria.h>

namespace signorini
{
  /**
   * The coarse mesh of one body in its place, with the boundary ids of its shape. Manifolds, which
   * say where refinement puts new vertices, are attached: round surfaces stay round.
   */
  template <int dim>
  void make_coarse_mesh(const BodyDescription<dim> &body, dealii::Triangulation<dim> &mesh);
} // namespace signorini

#endif
