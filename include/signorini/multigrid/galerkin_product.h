// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_galerkin_product_h
#define signorini_multigrid_galerkin_product_h

#include <signorini/linear_algebra/elastic_matrices.h>
#include <signorini/multigrid/interpolation.h>

namespace signorini
{
  /**
   * P'M P and P'A P: the matrices of the coarse level, again a block and a number for each pair of
   * nodes, because P interpolates all components alike; translations have no stress there either.
   * So a coarse level is good for every step size. Collective.
   * @param fine with the rows of the owned nodes complete
   * @param interpolation of its local nodes, ghosts included
   */
  template <int dim>
  ElasticMatrices<dim> galerkin_product(const ElasticMatrices<dim> &fine,
                                        const Interpolation        &interpolation,
                                        MPI_Comm                    communicator);
} // namespace signorini

#endif
