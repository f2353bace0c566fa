// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_lanes_h
#define signorini_linear_algebra_lanes_h

#include <cstring>

namespace signorini
{
  /**
   * Four numbers in one register. The components of a node fill the first dim lanes; what the
   * others hold is never used, so a column of a small block is loaded together with what follows it
   * in memory. Arrays of blocks therefore end with one spare block. The attribute and the shuffles
   * are extensions that GCC (12 or newer) and Clang share.
   */
  template <typename Number>
  using Lanes __attribute__((vector_size(4 * sizeof(Number)))) = Number;

  inline constexpr int prefetch_distance = 2048; ///< bytes

  /**
   * Ask for what a pass over a matrix will read soon. A product waits for memory, and the processor
   * alone does not look beyond the next few lines (measured: 1.5 times the speed).
   */
  template <unsigned int size = 64>
  inline void prefetch(const void *now_read)
  {
    for (unsigned int line = 0; line < size; line += 64)
      __builtin_prefetch(static_cast<const char *>(now_read) + prefetch_distance + line);
  }

  /** The same for a pass from the end to the start. */
  inline void prefetch_backwards(const void *now_read)
  {
    __builtin_prefetch(static_cast<const char *>(now_read) - prefetch_distance);
  }

  template <typename Number>
  inline Lanes<Number> load(const Number *numbers)
  {
    Lanes<Number> lanes;
    std::memcpy(&lanes, numbers, sizeof(lanes));
    return lanes;
  }

  inline void store(float *numbers, const Lanes<float> lanes)
  {
    std::memcpy(numbers, &lanes, sizeof(lanes));
  }

  /** One by one, of which GCC makes one instruction; of __builtin_convertvector() it makes four. */
  inline Lanes<double> in_double_precision(const Lanes<float> lanes)
  {
    return Lanes<double>{lanes[0], lanes[1], lanes[2], lanes[3]};
  }

  /** block x, the block stored column by column. */
  template <int dim, typename Number>
  inline Lanes<Number> block_product(const Number *block, const Number *x)
  {
    Lanes<Number> sum = load(block) * x[0];
    for (int c = 1; c < dim; ++c)
      sum += load(block + dim * c) * x[c];
    return sum;
  }

  template <int dim, typename Number>
  inline Lanes<Number> block_product(const Number *block, const Lanes<Number> x)
  {
    Lanes<Number> sum = load(block) * x[0];
    for (int c = 1; c < dim; ++c)
      sum += load(block + dim * c) * x[c];
    return sum;
  }

  /** Set the lanes beyond the components of a node to zero. */
  template <int dim, typename Number>
  inline Lanes<Number> without_spare_lanes(Lanes<Number> lanes)
  {
    for (int c = dim; c < 4; ++c)
      lanes[c] = 0;
    return lanes;
  }

  /** Transposed block times x, the block stored column by column. */
  template <int dim>
  inline Lanes<float> block_transposed_product(const float *block, const Lanes<float> x)
  {
    // Whole rows of the block, picked from its numbers, meet one component of x each.
    if constexpr (dim == 2)
      {
        const Lanes<float> all = load(block);
        return __builtin_shufflevector(all, all, 0, 2, 0, 2) * x[0]
               + __builtin_shufflevector(all, all, 1, 3, 1, 3) * x[1];
      }
    else
      {
        const Lanes<float> first = load(block), second = load(block + 3), third = load(block + 5);
        const Lanes<float> upper = __builtin_shufflevector(first, second, 0, 4, 1, 5);
        const Lanes<float> lower = __builtin_shufflevector(first, second, 2, 6, 3, 7);
        return __builtin_shufflevector(upper, third, 0, 1, 5, 5) * x[0]
               + __builtin_shufflevector(upper, third, 2, 3, 6, 6) * x[1]
               + __builtin_shufflevector(lower, third, 0, 1, 7, 7) * x[2];
      }
  }

  /** The same in double precision; the lanes of x beyond dim must be zero. */
  template <int dim>
  inline Lanes<double> block_transposed_product(const double *block, const Lanes<double> x)
  {
    // Each component of the result is the sum of the lanes of one product; pairs of lanes are added
    // side by side.
    const Lanes<double> zero{}, first = load(block) * x, second = load(block + dim) * x;
    const Lanes<double> third = dim == 3 ? load(block + 2 * dim * (dim == 3)) * x : zero;
    const Lanes<double> left  = __builtin_shufflevector(first, second, 0, 4, 2, 6)
                               + __builtin_shufflevector(first, second, 1, 5, 3, 7);
    const Lanes<double> right = __builtin_shufflevector(third, zero, 0, 4, 2, 6)
                                + __builtin_shufflevector(third, zero, 1, 5, 3, 7);
    return __builtin_shufflevector(left, right, 0, 1, 4, 5)
           + __builtin_shufflevector(left, right, 2, 3, 6, 7);
  }
} // namespace signorini

#endif
