// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_surface_crossing_h
#define signorini_obstacles_surface_crossing_h

#include <signorini/obstacles/faceted_surface.h>

namespace signorini
{
  /**
   * Check that no two facets of a surface pass through each other: where they do, the nearest of
   * them does not tell the inside from the outside. What only touches is not found.
   * @throws UserError saying where
   */
  template <int dim>
  void check_that_nothing_crosses(const FacetedSurface<dim> &surface);
} // namespace signorini

#endif
