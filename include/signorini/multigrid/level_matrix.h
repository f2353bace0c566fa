// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_level_matrix_h
#define signorini_multigrid_level_matrix_h

#include <signorini/linear_algebra/elastic_matrices.h>
#include <signorini/multigrid/level_vector.h>

#include <Eigen/Core>

namespace signorini
{
  /**
   * a M + b A of a level in single or double precision, the upper triangle as in ElasticMatrices. A
   * acts on differences of displacements here, too: else the round-off of a translation would be
   * larger than the mass where steps are large. Where a level is that of the next coarser one, it
   * is not smoothed, and couplings among nodes that are not smoothed are left out.
   */
  template <int dim, typename Number>
  class LevelMatrix
  {
  public:
    /**
     * Collective.
     * @param smoothed owned nodes: 1 if the level smooths there
     * @param scale    the matrix is multiplied by this, to be of the order of one
     */
    LevelMatrix(const ElasticMatrices<dim> &matrices,
                const std::vector<char>    &smoothed,
                const MatrixSum            &sum,
                double                      scale);

    unsigned int n_owned() const { return nodes.n_owned; }
    /** On all processes. */
    dealii::types::global_dof_index first_owned() const { return nodes.first_owned; }
    MPI_Comm                        communicator() const { return ghosts.communicator(); }

    /** The owned nodes where the level smooths, ascending. */
    const std::vector<unsigned int> &smoothed_nodes() const { return to_smooth; }

    /**
     * r -= K x: of smoothed nodes for any x, and of the others for one that is zero in nodes that
     * are not smoothed. Collective.
     */
    void subtract_product(const LevelVector<Number> &x, LevelVector<Number> &r) const;

    using Block = Eigen::Matrix<double, dim, dim>;

    /** The diagonal block of an owned node; zero if the node hangs. */
    const Block &diagonal(const unsigned int node) const { return diagonal_blocks[node]; }

  private:
    /** Side by side, so that each arithmetic operation works on all of them. */
    static constexpr unsigned int n_side_by_side = 32 / sizeof(Number);

    /**
     * Blocks of one row with owned columns; where there are fewer, zeros with the row's own node.
     * In the order in which a product reads it: otherwise the processor does not see what it will
     * need next (measured: half the speed).
     */
    struct Group
    {
      unsigned int column[n_side_by_side];
      Number       mass[n_side_by_side];
      Number       stiffness[dim * dim][n_side_by_side]; ///< column by column
    };
    /** A block whose column is a ghost. */
    struct GhostEntry
    {
      Number       stiffness[dim * dim + 4]; ///< column by column; see Lanes
      Number       mass;
      unsigned int row, column;
    };
    LocalNodes                nodes;
    std::vector<unsigned int> to_smooth;
    std::vector<unsigned int> group_start; ///< by row
    std::vector<Group>        groups;
    std::vector<GhostEntry>   ghost_entries;
    /**
     * Forces on a node if all nodes move alike: there are some beside clamped nodes, which coarser
     * levels do not have.
     */
    struct Support
    {
      Number       stiffness[dim * dim + 4]; ///< column by column; see Lanes
      unsigned int node;
    };
    std::vector<Support> supports;
    std::vector<Number>  diagonal_mass;
    std::vector<Block>   diagonal_blocks;
    GhostValues          ghosts;

    /** @param smoothed with ghosts */
    void add_row(const ElasticMatrices<dim> &matrices,
                 const std::vector<char>    &smoothed,
                 const MatrixSum            &sum,
                 double                      scale,
                 unsigned int                row);
    /** Room for all that rows will have. @param smoothed with ghosts */
    void reserve(const NodePattern &pattern, const std::vector<char> &smoothed);
    /** Where the level smooths. */
    void find_supports(const ElasticMatrices<dim> &matrices, const MatrixSum &sum, double scale);
  };
} // namespace signorini

#endif
