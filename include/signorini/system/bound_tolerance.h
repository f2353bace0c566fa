// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_bound_tolerance_h
#define signorini_system_bound_tolerance_h

#include <signorini/base/types.h>

#include <algorithm>

namespace signorini
{
  /**
   * What a bound of an increment may be exceeded by: nothing that matters, neither to the size of
   * the bodies nor to the motion of the step, which may be very slow; but more than the round-off
   * of the gap.
   */
  inline double bound_tolerance(const Vector &increment, const double body_size)
  {
    return body_size * std::clamp(1e-6 * increment.linfty_norm() / body_size, 1e-16, 1e-12);
  }
} // namespace signorini

#endif
