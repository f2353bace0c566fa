// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/record_friction.h>

namespace signorini
{
  double record_friction(State &state, const IncrementSolution &solution, const double factor, Vector &contact_force)
  {
    if (solution.friction_reaction.size() == 0)
      return 0.;
    FrictionState &friction = state.friction;
    if (!friction.any())
      {
        friction.accumulated_slip.reinit(solution.slip);
        friction.slip_path.assign(solution.slip_length.size(), 0.);
      }
    friction.force = solution.friction_reaction;
    friction.force *= factor;
    contact_force += friction.force;
    friction.status = solution.status;
    friction.slip   = solution.slip;
    friction.accumulated_slip += solution.slip;
    for (std::size_t k = 0; k < friction.slip_path.size(); ++k)
      friction.slip_path[k] += solution.slip_length[k];
    return factor * solution.friction_work;
  }
} // namespace signorini
