// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_contact_rows_h
#define signorini_preconditioners_contact_rows_h

#include <signorini/contact/contact_coordinates.h>

#include <boost/serialization/array.hpp>

#include <map>

namespace signorini
{
  /** A contact node with partners, as other processes need to know it. */
  template <int dim>
  struct ContactRow
  {
    dealii::types::global_dof_index      node;       ///< global node
    std::vector<std::array<double, dim>> directions; ///< those of its frame that are relative
    NodeWeights                          partners;
    std::vector<dealii::types::global_dof_index>
      neighbours; ///< nodes that the stiffness couples with it, itself included

    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &node &directions &partners &neighbours;
    }
  };

  /**
   * The contact nodes with partners that this process owns, is coupled with by the stiffness, or
   * owns a partner of, and the neighbours of the latter: all that its rows of the matrix in
   * relative coordinates need. Collective.
   */
  template <int dim>
  std::vector<ContactRow<dim>> gather_contact_rows(const NodePattern             &pattern,
                                                   const ContactCoordinates<dim> &coordinates);

  /** A block row of the full (not only upper) matrix: blocks, column by column, by global node. */
  template <int dim>
  using BlockRow =
    std::vector<std::pair<dealii::types::global_dof_index, std::array<double, dim * dim>>>;

  /** The rows of a M + b A for nodes (global) that other processes own. Collective. */
  template <int dim>
  std::map<dealii::types::global_dof_index, BlockRow<dim>>
  import_rows(const ElasticMatrices<dim>                         &matrices,
              const MatrixSum                                    &sum,
              const std::vector<dealii::types::global_dof_index> &nodes);
} // namespace signorini

#endif
