// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_relative_rows_h
#define signorini_multigrid_relative_rows_h

#include <signorini/contact/contact_coordinates.h>

#include <map>

namespace signorini
{
  /**
   * How partners enter the relative entries of a node, for the rows e_j of its frame made
   * orthonormal: with e_j = sum_i C_ji n_i, n_i the rows of the frame, and P_i the weights of the
   * contact node whose row n_i is,
   *
   *   rho_j'u = e_j.u_p - sum_l a_l.u_l,    a_l = sum_i C_ji P_il n_i.
   *
   * The coordinates must outlive the object, which sees them as they are now.
   */
  template <int dim>
  class RelativeRows
  {
  public:
    explicit RelativeRows(const ContactCoordinates<dim> &coordinates);

    /** A partner (global node) and its a_l. */
    using Row = std::vector<std::pair<dealii::types::global_dof_index, dealii::Tensor<1, dim>>>;

    /** Of a row of the frame of an owned node; empty where it is not relative. */
    Row row(unsigned int node, unsigned int component) const;

    /** See NodeCoupling::level(); 0 for nodes that are no contact nodes. */
    unsigned int level(unsigned int node) const;

  private:
    const ContactCoordinates<dim>                   &coordinates;
    std::map<unsigned int, std::vector<std::size_t>> contact_nodes; ///< of a node
  };
} // namespace signorini

#endif
