// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_improved_guess_h
#define signorini_linear_algebra_improved_guess_h

#include <algorithm>

namespace signorini
{
  /**
   * The norm of the residual to which a first guess is improved that is within the tolerance
   * already: what is wrong with a guess is alike in every step and adds up, unlike what iterations
   * leave.
   */
  inline double improved_guess(const double norm, const double tolerance)
  {
    return std::max(0.01 * tolerance, 0.1 * norm);
  }
} // namespace signorini

#endif
