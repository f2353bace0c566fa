// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_cell_geometry_h
#define signorini_model_cell_geometry_h

namespace signorini
{
  /** The maps from the reference cell to the cells of the mesh. */
  enum class CellGeometry
  {
    linear, ///< straight edges, isoparametric
    curved  ///< quadratic, along the manifolds of round shapes
  };
} // namespace signorini

#endif
