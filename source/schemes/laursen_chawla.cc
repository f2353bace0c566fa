// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/laursen_chawla.h>

#include <limits>

namespace signorini
{
  TakenStep LaursenChawla::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    // A node that is held at zero gap must not drop out by round-off.
    const double    touching = touching_distance(system.length());
    NormalGap       bounds   = system.normal_gap(start.displacement);
    const NormalGap gaps     = gaps_at_start(system, bounds);
    for (std::size_t k = 0; k < bounds.size(); ++k)
      if (gaps[k] > touching)
        bounds[k] = std::numeric_limits<double>::infinity();
      else
        bounds[k] -= gaps[k]; // the motion of the obstacle

    const Vector            b        = rule.right_hand_side(system, start, tau);
    const IncrementSolution solution = rule.solve(system, start, tau, b, bounds);
    return rule.finish_implicit(system, start, tau, solution);
  }
} // namespace signorini
