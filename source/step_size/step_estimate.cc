// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/step_estimate.h>

namespace signorini
{
  TakenStep
  take_step(TimeScheme &scheme, DynamicalSystem &system, const State &start, const double step_size)
  {
    TakenStep step{start, {}};
    step.report           = scheme.advance(system, step.state, step_size);
    step.report.step_size = step_size;
    return step;
  }


  void record_changes(const State &start, StepTrial &trial)
  {
    const State *before = &start;
    for (TakenStep &step : trial.steps)
      {
        LastStep &last       = step.state.last_step;
        last.size            = step.report.step_size;
        last.velocity_change = step.state.velocity;
        last.velocity_change -= before->velocity;
        last.momentum_change = step.state.momentum;
        last.momentum_change -= before->momentum;
        before = &step.state;
      }
  }
} // namespace signorini
