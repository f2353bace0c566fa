// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_shapes_place_h
#define signorini_shapes_place_h

#include <signorini/model/placement.h>

#include <deal.II/grid/grid_tools.h>

namespace signorini
{
  /** Move the vertices of a coarse mesh to their place; manifolds are left to the caller. */
  template <int dim>
  void place(const Placement<dim> &placement, dealii::Triangulation<dim> &mesh)
  {
    if (!placement.is_identity())
      dealii::GridTools::transform(
        [&placement](const dealii::Point<dim> &point) { return placement.place(point); }, mesh);
  }
} // namespace signorini

#endif
