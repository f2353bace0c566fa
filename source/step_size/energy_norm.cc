// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/energy_norm.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    Vector difference(const Vector &a, const Vector &b)
    {
      Vector result = a;
      result -= b;
      return result;
    }
  } // namespace


  double energy_of_motion(const State &state)
  {
    return 0.5 * (state.velocity * state.momentum + state.displacement * state.internal_force);
  }


  double energy_distance(const State &a, const State &b)
  {
    const double kinetic = difference(a.velocity, b.velocity) * difference(a.momentum, b.momentum);
    const double elastic =
      difference(a.displacement, b.displacement) * difference(a.internal_force, b.internal_force);
    return std::sqrt(0.5 * std::max(0., kinetic + elastic)); // below zero by round-off
  }
} // namespace signorini
