// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/incomplete_cholesky.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    template <int n>
    using Small = Eigen::Matrix<double, n, n, Eigen::RowMajor>;

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
      return Eigen::Map<const Eigen::Matrix<float, n, n, Eigen::RowMajor>>(entry.data()).template cast<double>();
    }

    template <int n>
    std::array<float, n * n> to_float(const Small<n> &entry)
    {
      std::array<float, n * n>                                         result;
      Eigen::Map<Eigen::Matrix<float, n, n, Eigen::RowMajor>>(result.data()) = entry.template cast<float>();
      return result;
    }
  } // namespace


  template <int dim, int block_size>
  IncompleteCholesky<dim, block_size>::IncompleteCholesky(const ElasticMatrices<dim>      &matrices,
                                                          const double                     mass_factor,
                                                          const double                     stiffness_factor,
                                                          const std::vector<unsigned int> &eliminate_last)
    : pattern(matrices.pattern)
    , overlapping(pattern.n_local > pattern.n_owned)
    , work(2 * dim * pattern.n_local)
    , ghosted_source(pattern.partitioner)
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
    set_held_nodes({});
  }


  template <int dim, int block_size>
  void IncompleteCholesky<dim, block_size>::build_pattern(const std::vector<unsigned int> &eliminate_last)
  {
    std::vector<char> is_last(pattern.n_local, 0);
    for (const unsigned int node : eliminate_last)
      is_last[node] = 1;
    order.reserve(pattern.n_local);
    for (const char last : {0, 1})
      for (unsigned int node = 0; node < pattern.n_local; ++node)
        if (is_last[node] == last)
          order.push_back(node);
    position_of.resize(pattern.n_local);
    for (unsigned int p = 0; p < pattern.n_local; ++p)
      position_of[order[p]] = p;

    row_start.assign(1, 0);
    for (unsigned int p = 0; p < pattern.n_local; ++p)
      {
        const unsigned int node = order[p];
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          if (position_of[pattern.columns[k]] < p)
            columns.push_back(position_of[pattern.columns[k]]);
        std::sort(columns.begin() + row_start.back(), columns.end());
        row_start.push_back(columns.size());
      }
    lower.resize(columns.size());
    pivots.resize(pattern.n_local);
    inverse_pivots.resize(pattern.n_local);
  }


  template <int dim, int block_size>
  bool IncompleteCholesky<dim, block_size>::factor(const ElasticMatrices<dim> &matrices,
                                                   const double                mass_factor,
                                                   const double                stiffness_factor,
                                                   const double                shift)
  {
    // One common scale keeps single precision away from overflow and underflow in any system of units.
    double scale = 0.;
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
        if (pattern.columns[k] == node)
          scale = std::max(scale, matrix_block<dim, block_size>(matrices, k, mass_factor, stiffness_factor).trace());
    if (scale > 0.)
      scale = 1. / scale;
    else
      scale = 1.;
    matrix_scale = scale;

    std::vector<Small<block_size>> inverse(pattern.n_local);
    std::vector<Small<block_size>> row(pattern.n_local, Small<block_size>::Zero()), scaled_row(row);
    std::vector<char>              in_row(pattern.n_local, 0);
    for (unsigned int i = 0; i < pattern.n_local; ++i)
      {
        Small<block_size>  pivot = Small<block_size>::Zero();
        const unsigned int node  = order[i];
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          {
            const unsigned int      j     = position_of[pattern.columns[k]];
            const Small<block_size> block = scale * matrix_block<dim, block_size>(matrices, k, mass_factor, stiffness_factor);
            if (j < i)
              {
                row[j]    = block;
                in_row[j] = 1;
              }
            else if (j == i)
              pivot = (1. + shift) * block;
          }
        if (pivot.trace() == 0.) // an eliminated (hanging) node: its entries are never free
          pivot.setIdentity();
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
        const Eigen::Map<const Small<dim>> frame(node.frame.data());
        Small<dim>                         local = frame * pivot * frame.transpose();
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
    float *y = work.data();
    float *s = work.data() + dim * pattern.n_local;
    std::fill(s, s + dim * pattern.n_local, 0.f);
    for (unsigned int i = 0; i < pattern.n_local; ++i)
      {
        std::array<float, dim> residual;
        for (unsigned int c = 0; c < dim; ++c)
          residual[c] = y[dim * i + c];
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          {
            const float *yj = y + dim * columns[a];
            for (unsigned int c = 0; c < dim; ++c)
              if constexpr (block_size == 1)
                residual[c] -= lower[a][0] * yj[c];
              else
                for (unsigned int d = 0; d < dim; ++d)
                  residual[c] -= lower[a][dim * c + d] * yj[d];
          }
        for (unsigned int c = 0; c < dim; ++c)
          {
            float value = 0.f;
            for (unsigned int d = 0; d < dim; ++d)
              value += inverse_pivots[i][dim * c + d] * residual[d];
            y[dim * i + c] = value;
          }
      }
    for (unsigned int i = pattern.n_local; i-- > 0;)
      {
        std::array<float, dim> z;
        for (unsigned int c = 0; c < dim; ++c)
          {
            z[c] = y[dim * i + c];
            for (unsigned int d = 0; d < dim; ++d)
              z[c] -= inverse_pivots[i][dim * c + d] * s[dim * i + d];
            y[dim * i + c] = z[c];
          }
        for (unsigned int a = row_start[i]; a < row_start[i + 1]; ++a)
          {
            float *sj = s + dim * columns[a];
            for (unsigned int c = 0; c < dim; ++c)
              if constexpr (block_size == 1)
                sj[c] += lower[a][0] * z[c];
              else
                for (unsigned int d = 0; d < dim; ++d)
                  sj[d] += lower[a][dim * c + d] * z[c];
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
        ghosted_source = source;
        ghosted_source.update_ghost_values();
        input = ghosted_source.begin();
      }
    // The sweeps are linear, so each process may scale its part to keep single precision in range.
    double size = 0.;
    for (unsigned int i = 0; i < dim * pattern.n_local; ++i)
      size = std::max(size, std::abs(input[i]));
    const double scale = size > 0. ? 1. / size : 0.;

    for (unsigned int p = 0; p < pattern.n_local; ++p)
      for (unsigned int c = 0; c < dim; ++c)
        work[dim * p + c] = weights[p] * static_cast<float>(scale * input[dim * order[p] + c]);
    sweep();

    destination.zero_out_ghost_values();
    double *output = destination.begin();
    for (unsigned int p = 0; p < pattern.n_local; ++p)
      for (unsigned int c = 0; c < dim; ++c)
        output[dim * order[p] + c] = size * matrix_scale * static_cast<double>(weights[p] * work[dim * p + c]);
    if (overlapping)
      destination.compress(dealii::VectorOperation::add);
  }


  template class IncompleteCholesky<2, 1>;
  template class IncompleteCholesky<2, 2>;
  template class IncompleteCholesky<3, 1>;
  template class IncompleteCholesky<3, 3>;
} // namespace signorini
