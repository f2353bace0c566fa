// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_algebraic_coarsening_h
#define signorini_multigrid_algebraic_coarsening_h

#include <signorini/linear_algebra/elastic_matrices.h>

#include <deal.II/base/point.h>

namespace signorini
{
  /** A coarser level that is a part of the nodes of a level. */
  struct Coarsening
  {
    std::vector<unsigned int> kept; ///< owned nodes, ascending
    /** What each owned node follows: indices into `kept`, and weights. */
    std::vector<std::vector<std::pair<unsigned int, double>>> parents;
    /** Nodes for which affine displacements are not exact: too many kept nodes lie in a line. */
    unsigned int n_not_affine = 0;
  };

  /**
   * Coarsen where the mesh has no coarser cells. No two kept nodes are strongly coupled, and each
   * node that goes is strongly coupled with one that stays (in thin bodies nodes go across the
   * thickness first). It follows the kept nodes around it with weights that give all affine
   * displacements exactly where these nodes allow it, rotations among them: so bending is no worse
   * on coarse levels than stretching is. Each process coarsens its own nodes on its own.
   * @param positions of the owned nodes
   */
  template <int dim>
  Coarsening coarsen(const ElasticMatrices<dim>            &matrices,
                     const std::vector<dealii::Point<dim>> &positions);
} // namespace signorini

#endif
