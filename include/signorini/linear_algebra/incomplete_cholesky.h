// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_incomplete_cholesky_h
#define signorini_linear_algebra_incomplete_cholesky_h

#include <signorini/linear_algebra/elastic_matrices.h>
#include <signorini/linear_algebra/lanes.h>
#include <signorini/linear_algebra/node_masks.h>

#include <deal.II/base/tensor.h>

#include <memory>

namespace signorini
{
  /**
   * Incomplete Cholesky factor without fill, (D + L) D^-1 (D + L'), of a matrix with blocks per
   * pair of nodes, in single precision: a preconditioner needs no more, and the sweeps run at the
   * speed of memory.
   *
   * `entry` is float for a block-scalar matrix (mass) and a dim x dim block for M + s A. Held
   * entries are skipped *inside* the sweeps: the inverse of D_p is replaced by its pseudo-inverse
   * on the free directions of node p. Nodes with contact are eliminated last, and therefore the
   * sweeps with any active set are those of the factor of the masked matrix (up to the coupling
   * among contact nodes): a change of the active set needs no new factor. Among each other the
   * nodes are numbered by Cuthill and McKee, which serves the quality of the factor equally well on
   * any number of processes (the reversed order is a little better on one process, and worse on
   * two).
   *
   * Several processes: each factors its owned nodes and one layer of ghosts; the local solutions
   * are added with the weights of a partition of unity to the power 1/2 on both sides, which keeps
   * the preconditioner symmetric.
   */
  template <int dim, int block_size>
  class IncompleteCholesky
  {
  public:
    /**
     * @param matrices         mass and stiffness; only their pattern is needed later
     * @param sum              what it is the factor of; the mass alone if block_size = 1
     * @param eliminate_last   local nodes (owned and ghosts) that come last, ascending
     */
    IncompleteCholesky(const ElasticMatrices<dim>      &matrices,
                       const MatrixSum                 &sum,
                       const std::vector<unsigned int> &eliminate_last);

    /** Replace the free directions of the nodes that are (partly) held. */
    void set_held_nodes(const HeldNodes<dim> &held);

    /** In Cartesian components. */
    void vmult(Vector &destination, const Vector &source) const;

    /** Number of applications since the start. */
    unsigned long n_applications() const { return applications; }

  private:
    using Entry    = std::array<float, block_size * block_size>; ///< column by column
    using Diagonal = std::array<float, dim * dim>;

    const NodePattern        &pattern;
    std::vector<unsigned int> order; ///< position in the elimination -> local node
    /** Strictly lower triangle by rows; positions instead of nodes. */
    std::vector<unsigned int> row_start, columns;
    std::vector<Entry>        lower;          ///< L, with a spare entry at the end, see Lanes
    std::vector<Entry>        pivots;         ///< D_p
    std::vector<Diagonal>     inverse_pivots; ///< pseudo-inverse on the free directions
    std::vector<unsigned int> position_of;    ///< local node -> position
    std::vector<unsigned int> held_positions; ///< whose inverse pivot differs from the full one
    std::vector<float>        weights;        ///< per position, root of the partition of unity
    bool                      overlapping;
    double matrix_scale = 1.; ///< the factor is that of matrix_scale times the matrix
    mutable std::vector<float> work, scattered; ///< four numbers per position
    mutable Vector
      ghosted; ///< with the ghosts of the pattern, which may be more than those of the vectors
    mutable unsigned long applications = 0;

    /**
     * Where an entry of the lower triangle comes from: position in the upper triangle of the
     * matrix, and whether it is turned.
     */
    struct Origin
    {
      unsigned int position;
      bool         transposed;
    };
    std::vector<Origin> origins; ///< like `columns`; only during the set-up

    void build_pattern(const std::vector<unsigned int> &eliminate_last);
    /** @return false if a pivot is not positive definite. */
    bool factor(const ElasticMatrices<dim> &matrices, const MatrixSum &sum, double shift);
    /** D_p as a block of all directions. */
    dealii::Tensor<2, dim> full_pivot(unsigned int position) const;
    void                   invert_pivot(unsigned int position);
    void                   sweep() const;
  };
} // namespace signorini

#endif
