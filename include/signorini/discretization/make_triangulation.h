// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_make_triangulation_h
#define signorini_discretization_make_triangulation_h

#include <signorini/model/body_description.h>

#include <deal.II/distributed/tria.h>

namespace signorini
{
  /**
   * Mesh all bodies as disconnected parts of one triangulation. Material id: index of the body;
   * boundary ids: those of the shape (a face belongs to the body of its cell).
   */
  template <int dim>
  void make_triangulation(const std::vector<BodyDescription<dim>>           &bodies,
                          dealii::parallel::distributed::Triangulation<dim> &triangulation);
} // namespace signorini

#endif
