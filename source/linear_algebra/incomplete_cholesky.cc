// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/cuthill_mckee.h>
#include <signorini/linear_algebra/incomplete_cholesky.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace signorini
{
  namespace
  {
    template <int n>
    using Small = Eigen::Matrix<double, n, n>;

    /** The block that the factor sees at a position of the pattern: dim x dim, or one number for the mass. */
    template <int dim, int n>
    Small<n> matrix_block(const ElasticMatrices<dim> &matrices, const unsigned int k, const double a, const double b)
    {
      if constexpr (n == 1)
        return Small<1>(a * matrices.mass[k]);
      else
        return Eigen::Map<const Small<n>>(matrices.combined_block(k, a, b).data());
    }

    template <int n>
    Small<n> to_double(const std::array<float, n * n> &entry)
    {
      return Eigen::Map<const Eigen::Matrix<float, n, n>>(entry.data()).template cast<double>();
    }

    template <int n>
    std::array<float, n * n> to_float(const Small<n> &entry)
    {
      std::array<float, n * n> result;
      Eigen::Map<Eigen::Matrix<float, n, n>>(result.data()) = entry.template cast<float>();
      return result;
    }
  } // namespace


  template <int dim, int block_size>
  IncompleteCholesky<dim, block_size>::IncompleteCholesky(const ElasticMatrices<dim>      &matrices,
                                                          const double                     mass_factor,
                                                          const double                     stiffness_factor,
                                                          const std::vector<unsigned int> &eliminate_last)
    : pattern(matrices.pattern)
    // For all processes: the exchange of overlapping parts is collective, even if one process has no ghosts.
    , overlapping(dealii::Utilities::MPI::max(static_cast<unsigned int>(pattern.n_local > pattern.n_owned),
                                              pattern.partitioner->get_mpi_communicator())
                  > 0)
    , work(4 * pattern.n_local, 0.f)
    , ghosted(pattern.partitioner)
  {
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

    // Without fill a pivot may become indefinite at large Courant numbers; a larger diagonal cures that (Manteuffel 1980).
    double shift = 0.;
    while (!factor(matrices, mass_factor, stiffness_factor, shift))
      {
        shift = shift == 0. ? 1e-3 : 4. * shift;
        if (shift > 1e3)
          throw RunError("The incomplete Cholesky factor does not exist: the matrix of the step is not positive "
                         "definite. Check the mesh for inverted cells, or set Solver/Preconditioner = jacobi.");
      }
    std::vector<Origin>().swap(origins); // assignment of an empty list would keep the memory
    set_held_nodes({});
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::build_pattern(const std::vector<unsigned int> &eliminate_last)
  {
    std::vector<char> is_last(pattern.n_local, 0);
    for (const unsigned int node : eliminate_last)
      is_last[node] = 1;
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
                                                   const double                mass_factor,
                                                   const double                stiffness_factor,
                                                   const double                shift)
  {
    const auto diagonal_block = [&](const unsigned int node) {
      return matrix_block<dim, block_size>(matrices, pattern.row_start[node], mass_factor, stiffness_factor);
    };
    // One common scale keeps single precision away from overflow and underflow in any system of units.
    double scale = 0.;
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      if (!pattern.is_empty(node))
        scale = std::max(scale, diagonal_block(node).trace());
    matrix_scale = scale = scale > 0. ? 1. / scale : 1.;

    std::vector<Small<block_size>> inverse(pattern.n_local);
    std::vector<Small<block_size>> row(pattern.n_local, Small<block_size>::Zero()), scaled_row(row);
    std::vector<char>              in_row(pattern.n_local, 0);
    for (unsigned int i = 0; i < pattern.n_local; ++i)
      {
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          {
            const Small<block_size> block =
              scale * matrix_block<dim, block_size>(matrices, origins[a].position, mass_factor, stiffness_factor);
            row[columns[a]]    = origins[a].transposed ? Small<block_size>(block.transpose()) : block;
            in_row[columns[a]] = 1;
          }
        // An eliminated (hanging) node has no entries, and its own are never free.
        Small<block_size> pivot = Small<block_size>::Identity();
        if (!pattern.is_empty(order[i]))
          pivot = (1. + shift) * scale * diagonal_block(order[i]);
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          {
            const unsigned int j = columns[a];
            for (unsigned int b = row_start[j]; b < row_start[j + 1]; ++b)
              if (in_row[columns[b]])
                row[j] -= scaled_row[columns[b]] * to_double<block_size>(lower[b]).transpose();
            scaled_row[j] = row[j] * inverse[j];
            pivot -= scaled_row[j] * row[j].transpose();
            lower[a] = to_float<block_size>(row[j]);
          }
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          in_row[columns[a]] = 0;
        const Eigen::LLT<Small<block_size>> cholesky(pivot);
        if (cholesky.info() != Eigen::Success)
          return false;
        inverse[i] = cholesky.solve(Small<block_size>::Identity());
        pivots[i]  = to_float<block_size>(pivot);
      }
    return true;
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::invert_pivot(const unsigned int p)
  {
    if constexpr (block_size == 1)
      inverse_pivots[p] = to_float<dim>(Small<dim>::Identity() / pivots[p][0]);
    else
      inverse_pivots[p] = to_float<dim>(to_double<dim>(pivots[p]).inverse());
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::set_held_nodes(const HeldNodes<dim> &held)
  {
    if (held.empty() && held_positions.empty())
      for (unsigned int p = 0; p < pattern.n_local; ++p)
        invert_pivot(p);
    for (const unsigned int p : held_positions)
      invert_pivot(p);
    held_positions.clear();

    for (const HeldNode<dim> &node : held)
      {
        const unsigned int p = position_of[node.node];
        Small<dim>         pivot;
        if constexpr (block_size == 1)
          pivot = pivots[p][0] * Small<dim>::Identity();
        else
          pivot = to_double<dim>(pivots[p]);
        // In the frame of the node the held entries become unit rows, which leaves the inverse on the free ones.
        const Eigen::Map<const Eigen::Matrix<double, dim, dim, Eigen::RowMajor>> frame(node.frame.data());
        Small<dim> local = frame * pivot * frame.transpose();
        for (unsigned int c = 0; c < dim; ++c)
          if (node.held[c])
            {
              local.row(c).setZero();
              local.col(c).setZero();
              local(c, c) = 1.;
            }
        local = local.inverse().eval();
        for (unsigned int c = 0; c < dim; ++c)
          if (node.held[c])
            local(c, c) = 0.;
        inverse_pivots[p] = to_float<dim>(frame.transpose() * local * frame);
        held_positions.push_back(p);
      }
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::sweep() const
  {
    const auto solve_pivot = [this](const unsigned int i, const Lanes<float> &right_hand_side) {
      std::array<float, 4> numbers;
      std::memcpy(numbers.data(), &right_hand_side, sizeof(right_hand_side));
      return without_spare_lanes<dim, float>(block_product<dim>(inverse_pivots[i].data(), numbers.data()));
    };
    // (D + L) y = r in place
    float *y = work.data();
    for (unsigned int i = 0; i < pattern.n_local; ++i)
      {
        Lanes<float> residual = load(y + 4 * i);
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          if constexpr (block_size == 1)
            residual -= lower[a][0] * load(y + 4 * columns[a]);
          else
            residual -= block_product<dim>(lower[a].data(), y + 4 * columns[a]);
        residual = solve_pivot(i, residual);
        std::memcpy(y + 4 * i, &residual, sizeof(residual));
      }
    // (I + D^-1 L') z = y in place. What has been read last is still in the cache: L is read backwards and not copied.
    scattered.assign(4 * pattern.n_local, 0.f);
    float *s = scattered.data();
    for (unsigned int i = pattern.n_local; i-- > 0;)
      {
        const Lanes<float> z = load(y + 4 * i) - solve_pivot(i, load(s + 4 * i));
        std::memcpy(y + 4 * i, &z, sizeof(z));
        for (unsigned int a = row_start[i + 1]; a-- > row_start[i];)
          {
            float       *target = s + 4 * columns[a];
            Lanes<float> sum    = load(target);
            if constexpr (block_size == 1)
              sum += lower[a][0] * z;
            else
              sum += block_transposed_product<dim, float>(lower[a].data(), z);
            std::memcpy(target, &sum, sizeof(sum));
          }
      }
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::vmult(Vector &destination, const Vector &source) const
  {
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
    sweep();

    ghosted.zero_out_ghost_values();
    destination.zero_out_ghost_values();
    double *output = overlapping ? ghosted.begin() : destination.begin();
    for (unsigned int p = 0; p < pattern.n_local; ++p)
      for (unsigned int c = 0; c < dim; ++c)
        output[dim * order[p] + c] = size * matrix_scale * static_cast<double>(weights[p] * work[4 * p + c]);
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
