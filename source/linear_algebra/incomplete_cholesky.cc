// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/cuthill_mckee.h>
#include <signorini/linear_algebra/flush_denormals.h>
#include <signorini/linear_algebra/incomplete_cholesky.h>
#include <signorini/linear_algebra/matrix_block.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace signorini
{
  namespace
  {
    using dealii::Tensor;
  } // namespace


  template <int dim, int block_size>
  IncompleteCholesky<dim, block_size>::IncompleteCholesky(
    const ElasticMatrices<dim>      &matrices,
    const MatrixSum                 &sum,
    const std::vector<unsigned int> &eliminate_last)
    : pattern(matrices.pattern)
    // For all processes: the exchange of overlapping parts is collective, even if one process has
    // no ghosts.
    , overlapping(
        dealii::Utilities::MPI::max(static_cast<unsigned int>(pattern.n_local > pattern.n_owned),
                                    pattern.partitioner->get_mpi_communicator())
        > 0)
    , work(4 * pattern.n_local, 0.f)
    , ghosted(pattern.partitioner)
  {
    Assert(sum.is_positive(), dealii::ExcMessage("Only positive definite matrices have a factor."));
    Assert(block_size == dim || (sum.stiffness == 0. && sum.damping == 0.),
           dealii::ExcMessage("The blocks of the stiffness are full."));
    Assert(std::is_sorted(eliminate_last.begin(), eliminate_last.end()),
           dealii::ExcMessage("The nodes that come last must be ascending."));
    build_pattern(eliminate_last);
    // The partition of unity: one over the number of processes that know a node.
    Vector multiplicity(pattern.partitioner);
    for (unsigned int i = 0; i < dim * pattern.n_local; ++i)
      multiplicity.local_element(i) = 1.;
    multiplicity.compress(dealii::VectorOperation::add);
    multiplicity.update_ghost_values();
    weights.resize(pattern.n_local);
    for (unsigned int p = 0; p < pattern.n_local; ++p)
      weights[p] = static_cast<float>(std::sqrt(1. / multiplicity.local_element(dim * order[p])));

    // Without fill a pivot may become indefinite at large Courant numbers; a larger diagonal cures
    // that (Manteuffel 1980).
    double shift = 0.;
    while (!factor(matrices, sum, shift))
      {
        shift = shift == 0. ? 1e-3 : 4. * shift;
        if (shift > 1e3)
          throw RunError("The incomplete Cholesky factor does not exist: the matrix of the step is "
                         "not positive definite. Check the mesh for inverted cells, or set "
                         "Solver/Preconditioner = jacobi.");
      }
    std::vector<Origin>().swap(origins); // assignment of an empty list would keep the memory
    for (unsigned int p = 0; p < pattern.n_local; ++p)
      invert_pivot(p);
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::build_pattern(
    const std::vector<unsigned int> &eliminate_last)
  {
    std::vector<char> is_last(pattern.n_local, 0);
    for (const unsigned int node : eliminate_last)
      {
        AssertIndexRange(node, pattern.n_local);
        is_last[node] = 1;
      }
    const std::vector<unsigned int> numbering = cuthill_mckee(pattern);
    order.reserve(pattern.n_local);
    for (const char last : {0, 1})
      for (const unsigned int node : numbering)
        if (is_last[node] == last)
          order.push_back(node);
    position_of.resize(pattern.n_local);
    for (unsigned int p = 0; p < pattern.n_local; ++p)
      position_of[order[p]] = p;

    const auto for_each_entry = [&](const auto &action) {
      for (unsigned int node = 0; node < pattern.n_local; ++node)
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          {
            const unsigned int i = position_of[node], j = position_of[pattern.columns[k]];
            if (i != j)
              action(std::max(i, j), std::min(i, j), Origin{k, j > i});
          }
    };
    // Sorted by columns first: in this order each row gets its entries by ascending columns.
    std::vector<unsigned int> column_start(pattern.n_local + 1, 0);
    row_start.assign(pattern.n_local + 1, 0);
    for_each_entry([&](const unsigned int row, const unsigned int column, const Origin &) {
      ++row_start[row + 1];
      ++column_start[column + 1];
    });
    std::partial_sum(row_start.begin(), row_start.end(), row_start.begin());
    std::partial_sum(column_start.begin(), column_start.end(), column_start.begin());
    std::vector<std::pair<unsigned int, Origin>> by_column(row_start.back());
    std::vector<unsigned int>                    next(column_start.begin(), column_start.end() - 1);
    for_each_entry([&](const unsigned int row, const unsigned int column, const Origin &origin) {
      by_column[next[column]++] = {row, origin};
    });
    next.assign(row_start.begin(), row_start.end() - 1);
    columns.resize(row_start.back());
    origins.resize(row_start.back());
    for (unsigned int column = 0; column < pattern.n_local; ++column)
      for (unsigned int e = column_start[column]; e < column_start[column + 1]; ++e)
        {
          const auto &[row, origin] = by_column[e];
          columns[next[row]]        = column;
          origins[next[row]++]      = origin;
        }
    lower.resize(columns.size() + 1);
    pivots.resize(pattern.n_local);
    inverse_pivots.resize(pattern.n_local + 1); // one spare, see Lanes
  }


  template <int dim, int block_size>
  bool IncompleteCholesky<dim, block_size>::factor(const ElasticMatrices<dim> &matrices,
                                                   const MatrixSum            &sum,
                                                   const double                shift)
  {
    const auto diagonal_block = [&](const unsigned int node) {
      return matrix_block<dim, block_size>(matrices, node, pattern.row_start[node], sum);
    };
    // One common scale keeps single precision away from overflow and underflow in any system of
    // units.
    double scale = 0.;
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      if (!pattern.is_empty(node))
        scale = std::max(scale, trace(diagonal_block(node)));
    matrix_scale = scale = scale > 0. ? 1. / scale : 1.;

    std::vector<Block<block_size>> inverse(pattern.n_local), row(pattern.n_local),
      scaled_row(pattern.n_local);
    std::vector<char> in_row(pattern.n_local, 0);
    for (unsigned int i = 0; i < pattern.n_local; ++i)
      {
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          {
            const auto block =
              scale * matrix_block<dim, block_size>(matrices, order[i], origins[a].position, sum);
            row[columns[a]]    = to_block(origins[a].transposed ? transpose(block) : block);
            in_row[columns[a]] = 1;
          }
        // An eliminated (hanging) node has no entries, and its own are never free.
        Tensor<2, block_size> pivot = dealii::unit_symmetric_tensor<block_size>();
        if (!pattern.is_empty(order[i]))
          pivot = (1. + shift) * scale * diagonal_block(order[i]);
        Block<block_size> remainder = to_block(pivot);
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          {
            const unsigned int j = columns[a];
            for (unsigned int b = row_start[j]; b < row_start[j + 1]; ++b)
              if (in_row[columns[b]])
                subtract_product(row[j], scaled_row[columns[b]], lower[b]);
            scaled_row[j] = product(row[j], inverse[j]);
            subtract_product(remainder, scaled_row[j], row[j]);
            lower[a] = to_float(to_tensor(row[j]));
          }
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          in_row[columns[a]] = 0;
        pivot = to_tensor(remainder);
        if (!is_positive_definite(pivot))
          return false;
        inverse[i] = to_block(invert(pivot));
        pivots[i]  = to_float(pivot);
      }
    return true;
  }


  template <int dim, int block_size>
  dealii::Tensor<2, dim> IncompleteCholesky<dim, block_size>::full_pivot(const unsigned int p) const
  {
    if constexpr (block_size == 1)
      return static_cast<double>(pivots[p][0])
             * Tensor<2, dim>(dealii::unit_symmetric_tensor<dim>());
    else
      return to_tensor<dim>(pivots[p]);
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::invert_pivot(const unsigned int p)
  {
    inverse_pivots[p] = to_float(invert(full_pivot(p)));
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::set_held_nodes(const HeldNodes<dim> &held)
  {
    for (const unsigned int p : held_positions)
      invert_pivot(p);
    held_positions.clear();

    for (const HeldNode<dim> &node : held)
      {
        AssertIndexRange(node.node, pattern.n_local);
        const unsigned int p = position_of[node.node];
        // In the frame of the node the held entries become unit rows, which leaves the inverse on
        // the free ones.
        const Tensor<2, dim> frame = transpose(to_tensor<dim>(node.frame));
        Tensor<2, dim>       local = frame * full_pivot(p) * transpose(frame);
        for (unsigned int c = 0; c < dim; ++c)
          if (node.held[c])
            {
              for (unsigned int d = 0; d < dim; ++d)
                local[c][d] = local[d][c] = 0.;
              local[c][c] = 1.;
            }
        local = invert(local);
        for (unsigned int c = 0; c < dim; ++c)
          if (node.held[c])
            local[c][c] = 0.;
        inverse_pivots[p] = to_float<dim>(transpose(frame) * local * frame);
        held_positions.push_back(p);
      }
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::sweep() const
  {
    const auto solve_pivot = [this](const unsigned int i, const Lanes<float> &right_hand_side) {
      std::array<float, 4> numbers;
      std::memcpy(numbers.data(), &right_hand_side, sizeof(right_hand_side));
      return without_spare_lanes<dim, float>(
        block_product<dim>(inverse_pivots[i].data(), numbers.data()));
    };
    const auto *blocks     = lower.data(); // the compiler cannot know that they stay
    const auto *columns_of = columns.data();
    const auto *start      = row_start.data();
    // (D + L) y = r in place
    float *y = work.data();
    for (unsigned int i = 0; i < pattern.n_local; ++i)
      {
        Lanes<float>       residual = load(y + 4 * i);
        const unsigned int last     = start[i + 1];
        for (unsigned int a = start[i]; a < last; ++a)
          {
            if constexpr (block_size > 1)
              prefetch(blocks[a].data());
            residual -= times<dim>(blocks[a], y + 4 * columns_of[a]);
          }
        residual = solve_pivot(i, residual);
        std::memcpy(y + 4 * i, &residual, sizeof(residual));
      }
    // (I + D^-1 L') z = y in place. What has been read last is still in the cache: L is read
    // backwards and not copied.
    scattered.assign(4 * pattern.n_local, 0.f);
    float *s = scattered.data();
    for (unsigned int i = pattern.n_local; i-- > 0;)
      {
        const Lanes<float> z = load(y + 4 * i) - solve_pivot(i, load(s + 4 * i));
        std::memcpy(y + 4 * i, &z, sizeof(z));
        const unsigned int first = start[i];
        for (unsigned int a = start[i + 1]; a-- > first;)
          {
            if constexpr (block_size > 1)
              prefetch_backwards(blocks[a].data());
            float *target = s + 4 * columns_of[a];
            store(target, load(target) + transposed_times<dim>(blocks[a], z));
          }
      }
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::vmult(Vector &destination, const Vector &source) const
  {
    AssertDimension(source.locally_owned_size(), dim * pattern.n_owned);
    AssertDimension(destination.locally_owned_size(), dim * pattern.n_owned);
    ++applications;
    const double *input = source.begin();
    if (overlapping)
      {
        ghosted.copy_locally_owned_data_from(source);
        ghosted.update_ghost_values();
        input = ghosted.begin();
      }
    // The sweeps are linear, so each process may scale its part to keep single precision in range.
    double size = 0.;
    for (unsigned int i = 0; i < dim * pattern.n_local; ++i)
      size = std::max(size, std::abs(input[i]));
    const double scale = size > 0. ? 1. / size : 0.;

    for (unsigned int p = 0; p < pattern.n_local; ++p)
      for (unsigned int c = 0; c < dim; ++c)
        work[4 * p + c] = weights[p] * static_cast<float>(scale * input[dim * order[p] + c]);
    {
      const FlushDenormals flush;
      sweep();
    }

    ghosted.zero_out_ghost_values();
    destination.zero_out_ghost_values();
    double *output = overlapping ? ghosted.begin() : destination.begin();
    for (unsigned int p = 0; p < pattern.n_local; ++p)
      for (unsigned int c = 0; c < dim; ++c)
        output[dim * order[p] + c] =
          size * matrix_scale * static_cast<double>(weights[p] * work[4 * p + c]);
    if (overlapping)
      {
        ghosted.compress(dealii::VectorOperation::add);
        destination.copy_locally_owned_data_from(ghosted);
      }
  }


  template class IncompleteCholesky<2, 1>;
  template class IncompleteCholesky<2, 2>;
  template class IncompleteCholesky<3, 1>;
  template class IncompleteCholesky<3, 3>;
} // namespace signorini
