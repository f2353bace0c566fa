// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_relative_matrix_h
#define signorini_preconditioners_relative_matrix_h

#include <signorini/contact/contact_coordinates.h>

namespace signorini
{
  /**
   * The entries of the matrix of two bodies in contact in relative coordinates, for
   * preconditioners: S'(a M + b A)S with
   *
   *   u = S v,    u_p = v_p + Pi_p sum_l P_pl v_l at contact nodes,    u_p = v_p elsewhere
   *
   * with the projector Pi_p onto the relative directions of the node (the transformation T without
   * its rotations, so that blocks of nodes stay blocks). It couples the partners of contact nodes
   * with the contact nodes, their neighbours and each other; elsewhere it is a M + b A.
   *
   * The ghosts are those of the given matrices and, beyond, the nodes that this process is coupled
   * with across the contact surface, so that a domain decomposition overlaps there, too, even if
   * each body lives on a process of its own. Collective.
   * @return matrices whose `stiffness` is the sum and whose `mass` is zero; entries for a factor,
   * not for products, which take it that no translation has a stress
   */
  template <int dim>
  ElasticMatrices<dim> relative_matrix(const ElasticMatrices<dim>    &matrices,
                                       const ContactCoordinates<dim> &coordinates,
                                       const MatrixSum               &sum);
} // namespace signorini

#endif
