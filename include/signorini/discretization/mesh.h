// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_mesh_h
#define signorini_discretization_mesh_h

#include <signorini/scene/scene.h>

#include <deal.II/distributed/tria.h>

namespace signorini
{
  /**
   * Mesh all bodies of a scene as disconnected parts of one triangulation. Material id: index of the body; boundary ids:
   * those of the shape (a face belongs to the body of its cell).
   */
  template <int dim>
  void make_mesh(const Scene<dim> &scene, dealii::parallel::distributed::Triangulation<dim> &triangulation);
} // namespace signorini

#endif
