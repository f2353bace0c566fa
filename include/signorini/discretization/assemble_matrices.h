// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_assemble_matrices_h
#define signorini_discretization_assemble_matrices_h

#include <signorini/discretization/mass_change.h>

namespace signorini
{
  template <int dim>
  class Discretization;

  /**
   * Consistent mass and stiffness of linear elasticity, hanging nodes eliminated: blocks per pair
   * of nodes, with the rows of the ghosts. Ghosts are all nodes of other processes that are coupled
   * with an owned one or that the owned cells write to. Cells are added to where their values stay;
   * no other sparse matrix is made. With several processes two rounds of messages follow, see
   * complete_rows(). The counts of products go on. Collective.
   * @param change if not empty on any process: what is added to the mass of the time
   *               discretisation, which is then kept beside the consistent one. It may couple nodes
   *               that no cell couples. Entries of owned rows only, both triangles.
   */
  template <int dim>
  void assemble_matrices(const Discretization<dim> &discretization,
                         ElasticMatrices<dim>      &matrices,
                         const MassChange          &change = {});
} // namespace signorini

#endif
