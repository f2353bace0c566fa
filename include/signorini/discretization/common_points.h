// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_common_points_h
#define signorini_discretization_common_points_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <vector>

namespace signorini
{
  /**
   * The points of all processes, one process after the other; the same on all. Collective. They
   * travel as numbers: deal.II compresses what is not trivially copyable, also for one process.
   */
  template <int dim>
  std::vector<dealii::Point<dim>> common_points(const std::vector<dealii::Point<dim>> &own,
                                                MPI_Comm communicator);
} // namespace signorini

#endif
