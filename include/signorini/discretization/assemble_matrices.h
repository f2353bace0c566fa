// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_assemble_matrices_h
#define signorini_discretization_assemble_matrices_h

#include <signorini/linear_algebra/elastic_matrices.h>

namespace signorini
{
  template <int dim>
  class Discretization;

  /**
   * Consistent mass and stiffness of linear elasticity, hanging nodes eliminated. Trilinos sums the contributions of all
   * processes; the result is kept as blocks per pair of nodes, with the rows of the ghosts.
   */
  template <int dim>
  void assemble_matrices(const Discretization<dim> &discretization, ElasticMatrices<dim> &matrices);
} // namespace signorini

#endif
