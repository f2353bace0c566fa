// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/matrix_block.h>
#include <signorini/sweeps/unit_diagonal_matrix.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace signorini
{
  namespace
  {
    using dealii::Tensor;

    /** C^-1 of the Cholesky factor C of a block. */
    template <int n>
    Tensor<2, n> inverse_root(const Tensor<2, n> &block)
    {
      Tensor<2, n> root, inverse;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j)
          {
            double remainder = block[i][j];
            for (int k = 0; k < j; ++k)
              remainder -= root[i][k] * root[j][k];
            if (i == j && !(remainder > 0.))
              throw RunError("The matrix of the step is not positive definite. Check the mesh for "
                             "inverted cells.");
            root[i][j] = i == j ? std::sqrt(remainder) : remainder / root[j][j];
          }
      for (int j = 0; j < n; ++j)
        for (int i = j; i < n; ++i)
          {
            double remainder = i == j;
            for (int k = j; k < i; ++k)
              remainder -= root[i][k] * inverse[k][j];
            inverse[i][j] = remainder / root[i][i];
          }
      return inverse;
    }
  } // namespace


  template <int dim, int block_size>
  UnitDiagonalMatrix<dim, block_size>::UnitDiagonalMatrix(const ElasticMatrices<dim> &matrices,
                                                          const MatrixSum            &sum,
                                                          SweepOrder                  sweep_order)
    : communicator(matrices.pattern.partitioner->get_mpi_communicator())
    , order(std::move(sweep_order))
  {
    Assert(sum.is_positive(), dealii::ExcMessage("Only definite matrices have roots."));
    Assert(block_size == dim || (sum.stiffness == 0. && sum.damping == 0.),
           dealii::ExcMessage("The blocks of the stiffness are full."));
    position_of.assign(matrices.pattern.n_owned, n_positions());
    for (unsigned int p = 0; p < n_positions(); ++p)
      position_of[order.nodes[p]] = p;
    find_pattern(matrices.pattern);
    const Roots roots = find_roots(matrices, sum);
    copy_couplings(matrices, sum, roots);
    copy_ghost_couplings(matrices, sum, roots);

    // One common scale keeps single precision away from overflow and underflow in any system of
    // units.
    for (const unsigned int node : order.nodes)
      root_scale = std::max(root_scale, roots[node].norm());
    root_scale = root_scale > 0. ? root_scale : 1.;
    inverse_roots.resize(n_positions() + 1);
    for (unsigned int p = 0; p < n_positions(); ++p)
      inverse_roots[p] = to_float((1. / root_scale) * roots[order.nodes[p]]);
  }


  template <int dim, int block_size>
  void UnitDiagonalMatrix<dim, block_size>::find_pattern(const NodePattern &pattern)
  {
    // Rows get their columns column by column, and so in ascending order.
    const unsigned int                     n = n_positions();
    std::vector<std::vector<unsigned int>> below(n); // by column
    row_start.assign(n + 1, 0);
    for (const unsigned int node : order.nodes)
      for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
        if (const unsigned int column = pattern.columns[k];
            column != node && column < pattern.n_owned && position_of[column] < n)
          {
            const auto [first, second] = std::minmax(position_of[node], position_of[column]);
            below[first].push_back(second);
            ++row_start[second + 1];
          }
    std::partial_sum(row_start.begin(), row_start.end(), row_start.begin());
    std::vector<unsigned int> next(row_start.begin(), row_start.end() - 1);
    columns.resize(row_start.back());
    for (unsigned int column = 0; column < n; ++column)
      for (const unsigned int row : below[column])
        columns[next[row]++] = column;
  }


  template <int dim, int block_size>
  typename UnitDiagonalMatrix<dim, block_size>::Roots
  UnitDiagonalMatrix<dim, block_size>::find_roots(const ElasticMatrices<dim> &matrices,
                                                  const MatrixSum            &sum)
  {
    const NodePattern &pattern = matrices.pattern;
    Roots              roots(pattern.n_local, Tensor<2, block_size>());
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (!pattern.is_empty(node)) // the others are hanging nodes, whose entries are never free
        roots[node] =
          inverse_root(matrix_block<dim, block_size>(matrices, node, pattern.row_start[node], sum));
    // Ghosts learn theirs row by row.
    for (unsigned int i = 0; i < block_size; ++i)
      {
        Vector row(pattern.partitioner);
        for (unsigned int node = 0; node < pattern.n_owned; ++node)
          for (unsigned int j = 0; j < block_size; ++j)
            row.local_element(dim * node + j) = roots[node][i][j];
        row.update_ghost_values();
        for (unsigned int node = pattern.n_owned; node < pattern.n_local; ++node)
          for (unsigned int j = 0; j < block_size; ++j)
            roots[node][i][j] = row.local_element(dim * node + j);
      }
    return roots;
  }


  template <int dim, int block_size>
  void UnitDiagonalMatrix<dim, block_size>::copy_couplings(const ElasticMatrices<dim> &matrices,
                                                           const MatrixSum            &sum,
                                                           const Roots                &roots)
  {
    const NodePattern &pattern = matrices.pattern;
    lower.resize(columns.size() + 1);
    for (const unsigned int node : order.nodes)
      for (unsigned int k = pattern.row_start[node] + 1; k < pattern.row_start[node + 1]; ++k)
        if (const unsigned int other = pattern.columns[k];
            other < pattern.n_owned && position_of[other] < n_positions())
          {
            const auto block = roots[node] * matrix_block<dim, block_size>(matrices, node, k, sum)
                               * transpose(roots[other]);
            const unsigned int here = position_of[node], there = position_of[other];
            const auto         begin = columns.begin() + row_start[std::max(here, there)],
                       end           = columns.begin() + row_start[std::max(here, there) + 1];
            const auto column        = std::lower_bound(begin, end, std::min(here, there));
            lower[column - columns.begin()] = to_float(here > there ? block : transpose(block));
          }
  }


  template <int dim, int block_size>
  void
  UnitDiagonalMatrix<dim, block_size>::copy_ghost_couplings(const ElasticMatrices<dim> &matrices,
                                                            const MatrixSum            &sum,
                                                            const Roots                &roots)
  {
    const NodePattern &pattern = matrices.pattern;
    for (unsigned int p = order.interface_begin; p < order.interface_end; ++p)
      {
        const unsigned int node = order.nodes[p];
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          if (const unsigned int other = pattern.columns[k]; other >= pattern.n_owned)
            {
              const unsigned int ghost = other - pattern.n_owned;
              GhostRows         &rows  = order.is_earlier(ghost) ? earlier : later;
              rows.ghosts.push_back(ghost);
              rows.blocks.push_back(
                to_float(roots[node] * matrix_block<dim, block_size>(matrices, node, k, sum)
                         * transpose(roots[other])));
            }
        earlier.row_start.push_back(earlier.ghosts.size());
        later.row_start.push_back(later.ghosts.size());
      }
    earlier.blocks.emplace_back();
    later.blocks.emplace_back();
  }


  template struct UnitDiagonalMatrix<2, 1>;
  template struct UnitDiagonalMatrix<2, 2>;
  template struct UnitDiagonalMatrix<3, 1>;
  template struct UnitDiagonalMatrix<3, 3>;
} // namespace signorini
