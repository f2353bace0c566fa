// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/energy_norm.h>
#include <signorini/step_size/step_estimate.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  StepError given_up(const StepError &error, const double time, const double size)
  {
    std::ostringstream text;
    text << "no step from the time " << time << " was possible, down to the size " << size << ". "
         << error.what();
    return StepError(text.str());
  }


  TakenStep
  take_step(TimeScheme &scheme, DynamicalSystem &system, const State &start, const double step_size)
  {
    TakenStep step        = scheme.make_step(system, start, step_size);
    step.report.step_size = step_size;
    // deal.II asserts that scalar products are finite, so the entries are looked at first.
    if (!std::isfinite(step.state.velocity.l1_norm() + step.state.displacement.l1_norm())
        || !std::isfinite(energy_of_motion(step.state)))
      throw StepError("The energy at its end is not a finite number. Check the loads, velocities "
                      "and material constants of the scene, or choose a smaller Time/Step size.");
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
