// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/oscillation.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  void TotalVariation::add(const double value)
  {
    variation += std::abs(value - last);
    last    = value;
    maximum = std::max(maximum, value);
  }


  void Zigzag::add(const double value, const bool counts)
  {
    if (++n_values > 2 && counts)
      {
        sum += std::abs(value - 2. * last + before) / 4.;
        ++n_counted;
      }
    before = last;
    last   = value;
  }
} // namespace signorini
