// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_sweeps_unit_diagonal_matrix_h
#define signorini_sweeps_unit_diagonal_matrix_h

#include <signorini/linear_algebra/elastic_matrices.h>
#include <signorini/sweeps/sweep_order.h>

#include <deal.II/base/tensor.h>

namespace signorini
{
  /**
   * C^-1 K C^-T in single precision, C the Cholesky factors of the diagonal blocks of K: a matrix
   * I + L + L' whose diagonal needs neither storage nor work. Its nodes are those of the order of a
   * sweep; if these are not all, K is the block of them.
   *
   * @tparam block_size dim, or 1 for the mass, a number per pair of nodes
   */
  template <int dim, int block_size>
  struct UnitDiagonalMatrix
  {
    /** @param sum what K is; the mass alone if block_size = 1. Collective */
    UnitDiagonalMatrix(const ElasticMatrices<dim> &matrices,
                       const MatrixSum            &sum,
                       SweepOrder                  order);

    using Block = std::array<float, block_size * block_size>; ///< column by column

    /** Couplings of the nodes of the interface with ghosts: rows of positions. */
    struct GhostRows
    {
      std::vector<unsigned int> row_start{0}, ghosts;
      std::vector<Block>        blocks; ///< with a spare one at the end, see Lanes
    };

    MPI_Comm                  communicator;
    SweepOrder                order;
    std::vector<unsigned int> position_of; ///< owned node -> position; n_positions() if it has none
    std::vector<unsigned int> row_start, columns; ///< L: positions
    std::vector<Block>        lower;              ///< L, with a spare block at the end
    GhostRows                 earlier, later;     ///< ghosts before and behind the interface
    std::vector<Block>        inverse_roots;      ///< C^-1/root_scale of positions, and a spare one
    double                    root_scale = 0.;    ///< of this process

    unsigned int n_positions() const { return order.nodes.size(); }
    bool         has_all_nodes() const { return n_positions() == position_of.size(); }

  private:
    using Roots = std::vector<dealii::Tensor<2, block_size>>;

    void find_pattern(const NodePattern &pattern);
    /** C^-1 of all local nodes. */
    static Roots find_roots(const ElasticMatrices<dim> &matrices, const MatrixSum &sum);
    void
    copy_couplings(const ElasticMatrices<dim> &matrices, const MatrixSum &sum, const Roots &roots);
    void copy_ghost_couplings(const ElasticMatrices<dim> &matrices,
                              const MatrixSum            &sum,
                              const Roots                &roots);
  };
} // namespace signorini

#endif
