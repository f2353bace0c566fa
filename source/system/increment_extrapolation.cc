// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/system/increment_extrapolation.h>

namespace signorini
{
  void IncrementExtrapolation::guess(Vector &increment) const
  {
    increment = 0.;
    // Binomial weights: 1; 2, -1; 3, -3, 1; ...
    const unsigned int n      = increments.size();
    double             weight = 1.;
    for (unsigned int k = 0; k < n; ++k)
      {
        weight *= (k == 0 ? 1. : -1.) * (n - k) / (k + 1.);
        increment.add(weight, increments[k]);
      }
  }


  void IncrementExtrapolation::remember(const Vector &increment)
  {
    if (increments.size() == n_kept)
      {
        increments.push_front(std::move(increments.back())); // reuse the memory of the oldest
        increments.pop_back();
        increments.front() = increment;
      }
    else
      increments.push_front(increment);
  }
} // namespace signorini
