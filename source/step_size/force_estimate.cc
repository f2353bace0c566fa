// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/contact_events.h>
#include <signorini/step_size/energy_norm.h>
#include <signorini/step_size/force_estimate.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * Elastic energies below this part of the largest energy are taken for it: far from where it
     * began, a body without deformation has one by round-off.
     */
    constexpr double noticeable = 1e-8;

    double elastic_energy(const State &state)
    {
      return 0.5 * (state.displacement * state.internal_force);
    }
  } // namespace


  StepTrial ForceEstimate::attempt(DynamicalSystem &system,
                                   const State     &start,
                                   const double     span,
                                   const double     tolerance)
  {
    StepTrial    trial = motion.attempt(system, start, span, tolerance);
    const State &end   = trial.steps.back().state;
    trial.is_flight    = !any_contact(trial.end_statuses, end.displacement);
    trial.exponent     = 0.5;
    if (trial.is_flight)
      trial.error = 0.;

    Vector change = end.contact_force;
    change -= start.contact_force;
    const double between =
      start.last_step.any() ? (start.last_step.size + span) / 2. : span; // from mean to mean
    const double forces = change.l1_norm() * span / between;
    if (forces > 0.)
      trial.error = std::max(
        trial.error, forces / largest_expected_force(start, end) * (span / unit) * (span / unit));
    return trial;
  }


  double ForceEstimate::largest_expected_force(const State &start, const State &end) const
  {
    const double before = start.contact_force.l1_norm();
    const double force  = std::max(before, end.contact_force.l1_norm());
    const double energy = std::max({so_far.energy, energy_of_motion(start), energy_of_motion(end)});
    const double least  = noticeable * energy;
    const double elastic = std::max(elastic_energy(end), least);
    const double largest = std::max(so_far.elastic_energy, least);
    const double growth  = elastic >= largest ? std::sqrt(std::max(1., energy / elastic)) : 1.;
    return std::max(so_far.force, force * growth);
  }


  void ForceEstimate::accept(const State &start, const State &end)
  {
    motion.accept(start, end);
    before        = so_far;
    so_far.force  = std::max(so_far.force, end.contact_force.l1_norm());
    so_far.energy = std::max({so_far.energy, energy_of_motion(start), energy_of_motion(end)});
    so_far.elastic_energy = std::max(so_far.elastic_energy, elastic_energy(end));
  }


  void ForceEstimate::take_back()
  {
    motion.take_back();
    so_far = before;
  }


  StepRules ForceEstimate::rules() const
  {
    StepRules rules;
    rules.content = 0.3; // forces waver: what is 1.2 for twice the size by now may soon be less
    rules.content_in_flight = 1.;
    rules.rest              = 0;
    rules.smallest_part     = 1. / 8.; // resting contact chatters in shorter and shorter steps
    rules.flight_is_free    = true;
    return rules;
  }
} // namespace signorini
