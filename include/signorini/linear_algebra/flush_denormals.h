// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_flush_denormals_h
#define signorini_linear_algebra_flush_denormals_h

#ifdef __SSE2__
#  include <xmmintrin.h>
#endif

namespace signorini
{
  /**
   * As long as it lives, numbers below the smallest normal one are zero. A preconditioner in single
   * precision spreads a force over the body, falling by a factor per node, until it arrives there;
   * such numbers say nothing, but arithmetic with them takes many times as long. Where the
   * processor does not offer it, nothing happens.
   */
  class FlushDenormals
  {
  public:
    FlushDenormals()
    {
#ifdef __SSE2__
      _mm_setcsr(before | results_are_zero | operands_are_zero);
#endif
    }
    ~FlushDenormals()
    {
#ifdef __SSE2__
      _mm_setcsr(before);
#endif
    }
    FlushDenormals(const FlushDenormals &)            = delete;
    FlushDenormals &operator=(const FlushDenormals &) = delete;

#ifdef __SSE2__
  private:
    static constexpr unsigned int results_are_zero = 0x8000, operands_are_zero = 0x0040;

    const unsigned int before = _mm_getcsr();
#endif
  };
} // namespace signorini

#endif
