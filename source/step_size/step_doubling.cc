// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/contact_events.h>
#include <signorini/step_size/energy_norm.h>
#include <signorini/step_size/step_doubling.h>

namespace signorini
{
  StepTrial StepDoubling::attempt(DynamicalSystem &system,
                                  const State     &start,
                                  const double     span,
                                  const double     tolerance)
  {
    StepTrial       coarse       = single.attempt(system, start, span, tolerance);
    const State    &end          = coarse.steps.back().state;
    const ActiveSet coarse_nodes = contact_statuses(system, end);
    if (coarse.is_known && coarse.is_flight && coarse.error <= tolerance)
      return coarse;

    StepTrial trial;
    trial.n_solved  = 3;
    trial.exponent  = 1. / 3.;
    trial.is_flight = coarse.is_flight;
    State state     = start;
    for (const double half : {span / 2., span / 2.})
      {
        const StepReport report = scheme.advance(system, state, half);
        trial.steps.push_back({state, report, half});
        if (differ(contact_statuses(system, state), coarse_nodes, state.displacement))
          trial.exponent = 2.;
      }
    const double error = energy_distance(state, end);
    if (error > 0.)
      trial.error = error / single.unit(start, state);
    return trial;
  }
} // namespace signorini
