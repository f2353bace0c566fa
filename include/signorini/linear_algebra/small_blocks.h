// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_small_blocks_h
#define signorini_linear_algebra_small_blocks_h

#include <signorini/linear_algebra/lanes.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace signorini
{
  /** A block of the factor in double precision, column by column. */
  template <int n>
  struct Block
  {
    Lanes<double> column[n];
  };

  /** A block, or its transpose, times the numbers of a node; or a number times these. */
  template <int dim, typename Entry>
  inline Lanes<float> times(const Entry &block, const float *x)
  {
    if constexpr (std::tuple_size<Entry>() == 1)
      return block[0] * load(x);
    else
      return block_product<dim, float>(block.data(), x);
  }
  template <int dim, typename Entry>
  inline Lanes<float> transposed_times(const Entry &block, const Lanes<float> x)
  {
    if constexpr (std::tuple_size<Entry>() == 1)
      return block[0] * x;
    else
      return block_transposed_product<dim>(block.data(), x);
  }

  /** Numbers that are stored column by column. */
  template <int n, typename Number>
  inline dealii::Tensor<2, n> to_tensor(const std::array<Number, n * n> &entry)
  {
    dealii::Tensor<2, n> result;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        result[i][j] = entry[n * j + i];
    return result;
  }

  template <int n>
  inline dealii::Tensor<2, n> to_tensor(const Block<n> &block)
  {
    dealii::Tensor<2, n> result;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        result[i][j] = block.column[j][i];
    return result;
  }

  template <int n>
  inline Block<n> to_block(const dealii::Tensor<2, n> &tensor)
  {
    Block<n> result{};
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        result.column[j][i] = tensor[i][j];
    return result;
  }

  template <int n>
  inline std::array<float, n * n> to_float(const dealii::Tensor<2, n> &tensor)
  {
    std::array<float, n * n> result;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        result[n * j + i] = static_cast<float>(tensor[i][j]);
    return result;
  }

  /** a b. */
  template <int n>
  inline Block<n> product(const Block<n> &a, const Block<n> &b)
  {
    Block<n> result{};
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        result.column[j] += a.column[k] * b.column[j][k];
    return result;
  }

  /** c -= a b'. */
  template <int n>
  inline void subtract_product(Block<n> &c, const Block<n> &a, const Block<n> &b)
  {
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        c.column[j] -= a.column[k] * b.column[k][j];
  }

  /** c -= a b', b column by column. */
  template <int n>
  inline void subtract_product(Block<n> &c, const Block<n> &a, const std::array<float, n * n> &b)
  {
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        c.column[j] -= a.column[k] * static_cast<double>(b[n * k + j]);
  }

  /** By the leading minors of a symmetric block. */
  template <int n>
  inline bool is_positive_definite(const dealii::Tensor<2, n> &block)
  {
    if (!(block[0][0] > 0.) || !(determinant(block) > 0.))
      return false;
    if constexpr (n == 3)
      return block[0][0] * block[1][1] - block[0][1] * block[1][0] > 0.;
    return true;
  }
} // namespace signorini

#endif
