// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/friction_of_step.h>

namespace signorini
{
  FrictionOfStep friction_of_step(const FrictionState     &before,
                                  const IncrementSolution &solution,
                                  const double             factor,
                                  Vector                  &contact_force)
  {
    FrictionOfStep friction;
    if (solution.friction_reaction.size() == 0)
      return friction;
    FrictionState &state = friction.state;
    state.force          = solution.friction_reaction;
    state.force *= factor;
    contact_force += state.force;
    state.status           = solution.status;
    state.slip             = solution.slip;
    state.accumulated_slip = solution.slip;
    state.slip_path        = solution.slip_length;
    if (before.any())
      {
        state.accumulated_slip += before.accumulated_slip;
        for (std::size_t k = 0; k < state.slip_path.size(); ++k)
          state.slip_path[k] += before.slip_path[k];
      }
    friction.work = factor * solution.friction_work;
    return friction;
  }
} // namespace signorini
