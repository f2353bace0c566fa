// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/moreau_jean.h>

#include <limits>

namespace signorini
{
  TakenStep MoreauJean::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    NormalGap       bounds   = system.normal_gap(start.displacement);
    const NormalGap approach = system.relative_normal(start.velocity);
    const double    touching = touching_distance(system.length());
    for (std::size_t k = 0; k < bounds.size(); ++k)
      {
        const double half_step = tau / 2. * approach[k];
        bounds[k] =
          bounds[k] - half_step <= touching ? half_step : std::numeric_limits<double>::infinity();
      }
    const Vector            b        = rule.right_hand_side(system, start, tau);
    const IncrementSolution solution = rule.solve(system, start, tau, b, bounds);
    return rule.finish_implicit(system, start, tau, solution);
  }
} // namespace signorini
