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
    StepTrial    coarse = single.attempt(system, start, span, tolerance);
    const State &end    = coarse.steps.back().state;
    if (coarse.is_known && coarse.is_flight && coarse.error <= tolerance)
      return coarse;

    StepTrial trial;
    trial.n_solved  = 3;
    trial.exponent  = 1. / 3.;
    trial.is_flight = coarse.is_flight;
    trial.steps.push_back(take_step(scheme, system, start, span / 2.));
    trial.steps.push_back(take_step(scheme, system, trial.steps.front().state, span / 2.));
    for (const TakenStep &step : trial.steps)
      {
        trial.end_statuses = contact_statuses(system, step.state);
        if (differ(trial.end_statuses, coarse.end_statuses, start.displacement))
          trial.exponent = 2.;
      }
    const State &fine_end = trial.steps.back().state;
    const double error    = energy_distance(fine_end, end);
    if (error > 0.)
      trial.error = error / single.unit(start, fine_end);
    return trial;
  }
} // namespace signorini
