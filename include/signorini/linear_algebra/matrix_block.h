// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_matrix_block_h
#define signorini_linear_algebra_matrix_block_h

#include <signorini/linear_algebra/elastic_matrices.h>
#include <signorini/linear_algebra/small_blocks.h>

namespace signorini
{
  /**
   * The block at a position of the row of a node as a factor of n x n blocks sees it: n = dim for
   * any sum, n = 1, one number, for the mass alone.
   */
  template <int dim, int n>
  dealii::Tensor<2, n> matrix_block(const ElasticMatrices<dim> &matrices,
                                    const unsigned int          node,
                                    const unsigned int          position,
                                    const MatrixSum            &sum)
  {
    if constexpr (n == 1)
      return to_tensor<1>(std::array<double, 1>{{sum.mass * matrices.mass[position]}});
    else
      return to_tensor<dim>(matrices.combined_block(node, position, sum));
  }
} // namespace signorini

#endif
