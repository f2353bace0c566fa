// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_lanes_h
#define signorini_linear_algebra_lanes_h

#include <cstring>

namespace signorini
{
  /**
   * Four numbers in one register. The components of a node fill the first dim lanes; what the others hold is never used, so a
   * column of a small block is loaded together with what follows it in memory. Arrays of blocks therefore end with one
   * spare block.
   */
  template <typename Number>
  using Lanes __attribute__((vector_size(4 * sizeof(Number)))) = Number;

  template <typename Number>
  inline Lanes<Number> load(const Number *numbers)
  {
    Lanes<Number> lanes;
    std::memcpy(&lanes, numbers, sizeof(lanes));
    return lanes;
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
} // namespace signorini

#endif
