// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/sum_of_magnitudes.h>
#include <signorini/step_size/contact_events.h>
#include <signorini/step_size/force_estimate.h>

#include <algorithm>

namespace signorini
{
  StepTrial ForceEstimate::attempt(DynamicalSystem &system,
                                   const State     &start,
                                   const double     span,
                                   const double     tolerance)
  {
    StepTrial    trial = motion.attempt(system, start, span, tolerance);
    const State &end   = trial.steps.back().state;
    trial.is_flight    = !any_contact(trial.end_statuses, end.displacement);
    trial.is_free      = trial.is_flight;
    trial.exponent     = 0.5;
    if (trial.is_flight)
      trial.error = 0.;

    Vector change = end.contact_force;
    change -= start.contact_force;
    const double between =
      start.last_step.any() ? (start.last_step.size + span) / 2. : span; // from mean to mean
    const double forces = size_of(change) * span / between;
    if (forces > 0.)
      {
        const double larger = std::max(size_of(start.contact_force), size_of(end.contact_force));
        const double part   = span / unit;
        trial.error =
          std::max(trial.error, forces / largest.expected(start, end, larger) * part * part);
      }
    return trial;
  }


  double ForceEstimate::size_of(const Vector &force) const
  {
    return sum_of_magnitudes(force, dimension);
  }


  void ForceEstimate::accept(const State &start, const State &end)
  {
    motion.accept(start, end);
    largest.accept(start, end, size_of(end.contact_force));
  }


  void ForceEstimate::take_back()
  {
    motion.take_back();
    largest.take_back();
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
