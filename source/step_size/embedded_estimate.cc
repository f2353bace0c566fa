// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/contact_events.h>
#include <signorini/step_size/embedded_estimate.h>
#include <signorini/step_size/energy_norm.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  StepTrial
  EmbeddedEstimate::attempt(DynamicalSystem &system, const State &start, const double span, double)
  {
    StepTrial trial;
    trial.n_solved = 1;
    trial.steps.push_back(take_step(scheme, system, start, span));
    const TakenStep &step = trial.steps.back();

    const ActiveSet start_statuses = contact_statuses(system, start);
    trial.end_statuses             = contact_statuses(system, step.state);
    const bool changed             = differ(start_statuses, trial.end_statuses, start.displacement);
    trial.exponent                 = changed ? 2. : 0.5;
    trial.is_flight                = !changed && !any_contact(start_statuses, start.displacement);
    trial.is_known                 = start.last_step.any();
    if (!trial.is_known)
      return trial;
    Vector velocity = step.state.velocity, momentum = step.state.momentum;
    velocity -= start.velocity;
    momentum -= start.momentum;
    const double at_rest = velocity * momentum;
    velocity.add(-span / start.last_step.size, start.last_step.velocity_change);
    momentum.add(-span / start.last_step.size, start.last_step.momentum_change);
    const double error = std::sqrt(0.5 * std::max(0., std::min(at_rest, velocity * momentum)));
    if (error > 0.)
      trial.error = error / unit(start, step.state);
    return trial;
  }


  double EmbeddedEstimate::unit(const State &start, const State &end) const
  {
    // A motion that begins at rest is measured by what it becomes.
    return std::sqrt(std::max({largest_energy, energy_of_motion(start), energy_of_motion(end)}));
  }


  void EmbeddedEstimate::accept(const State &start, const State &end)
  {
    largest_energy_before = largest_energy;
    largest_energy = std::max({largest_energy, energy_of_motion(start), energy_of_motion(end)});
  }
} // namespace signorini
