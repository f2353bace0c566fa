// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_increment_extrapolation_h
#define signorini_system_increment_extrapolation_h

#include <signorini/base/types.h>

#include <deque>

namespace signorini
{
  /**
   * First guess for the increment of the next step from those of the last ones, by the polynomial through them. In smooth motion
   * this spares iterations; in undeformed flight the guess is exact.
   */
  class IncrementExtrapolation
  {
  public:
    /** The guess; zero if nothing is known. */
    void guess(Vector &increment) const;

    /** Remember the increment of a step. */
    void remember(const Vector &increment);

    /** Forget everything: the next step has another size or another mesh. */
    void clear() { increments.clear(); }

  private:
    static constexpr unsigned int n_kept = 3;
    std::deque<Vector>            increments; ///< latest first
  };
} // namespace signorini

#endif
