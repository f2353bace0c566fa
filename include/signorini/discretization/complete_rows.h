// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_complete_rows_h
#define signorini_discretization_complete_rows_h

#include <signorini/discretization/local_nodes.h>
#include <signorini/discretization/mass_change.h>

namespace signorini
{
  /**
   * Sum the contributions of all processes: each sends what it has for the rows of others in one
   * round of messages; in a second one the owners return the finished rows of ghosts. Collective.
   * @param contributions  upper triangle over `nodes` from the cells of this process
   * @param nodes          owned nodes, and those of others that its cells write to
   * @param change         of the mass, in owned rows, both triangles; `mass_changes` tells whether
   *                       any process has one
   * @param result         pattern with all ghosts, and values; the consistent mass is kept beside a
   *                       changed one
   */
  template <int dim>
  void complete_rows(const ElasticMatrices<dim> &contributions,
                     const LocalNodes           &nodes,
                     const MassChange           &change,
                     bool                        mass_changes,
                     MPI_Comm                    communicator,
                     ElasticMatrices<dim>       &result);

  /** The partitioner of vectors with dim entries per node. Collective. */
  template <int dim>
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
  make_partitioner(const LocalNodes &nodes, MPI_Comm communicator);
} // namespace signorini

#endif
