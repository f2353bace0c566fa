// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/contact_events.h>
#include <signorini/step_size/goal_estimate.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /** What a rough course of the force counts for in the next stretch. */
    constexpr double fading = 0.7;
    constexpr double nearly = 1. - 1e-6; ///< but for round-off

    /**
     * Of the tolerance: errors below it allow a longer step, as twice the size has four times the
     * error. One between that and the tolerance hinders it.
     */
    constexpr double content = 0.1, hinders = 0.5;

    /**
     * The error of a single step may be so many times that of all of them together: that of a kink
     * is, and does not matter in the mean.
     */
    constexpr double of_single_steps = 2.;

    /** No contact force at both ends. */
    bool is_free(const State &start, const State &end)
    {
      return start.contact_force.l1_norm() == 0. && end.contact_force.l1_norm() == 0.;
    }
  } // namespace


  StepTrial GoalEstimate::attempt(DynamicalSystem &system,
                                  const State     &start,
                                  const double     span,
                                  const double     tolerance)
  {
    StepTrial    trial = motion.attempt(system, start, span, tolerance);
    const State &end   = trial.steps.back().state;
    trial.is_flight    = !any_contact(trial.end_statuses, end.displacement);
    trial.exponent     = 0.5;
    if (is_free(start, end))
      {
        trial.error       = 0.;
        tried             = with(start, end, 0.);
        tried.mean_square = 0.;
        return trial;
      }
    const double unit    = span * span / largest.expected(start, end);
    tried                = with(start, end, of_single_steps * tolerance / unit);
    const double usual   = std::sqrt(tried.mean_square) * unit;
    const double present = tried.roughness * unit;
    double       waves   = std::pow(trial.error, 2);
    if (span < nearly * 2. * first)
      waves = std::min(waves, hinders * tolerance);
    trial.error = std::max({usual, waves, present > of_single_steps * tolerance ? present : 0.});
    trial.error /= of_single_steps;
    return trial;
  }


  void GoalEstimate::Course::begin(const double time, const double size, const double force)
  {
    before = {time - size, size, 0., force};
    last   = {time, size, 0., force};
  }


  void GoalEstimate::Course::add(const ForceOfStep &stretch)
  {
    before  = last;
    last    = stretch;
    present = ForceOfStep();
  }


  GoalEstimate::Course
  GoalEstimate::with(const State &start, const State &end, const double most) const
  {
    const double size   = end.time - start.time;
    Course       result = course;
    if (result.last.size == 0.)
      result.begin(start.time, first, start.contact_force.l1_norm());
    ForceOfStep &sums = result.present;
    sums.size += size;
    sums.instant += size * (end.time - force_in_step.before_end * size);
    sums.force += size * end.contact_force.l1_norm();
    if (sums.size < nearly * first)
      return result;
    const ForceOfStep stretch{sums.instant / sums.size, sums.size, 0., sums.force / sums.size};
    ForceOfStep       middle = result.last;
    middle.size              = size;
    middle.delay             = force_in_step.delay() * size;
    result.roughness         = error_of_step(result.before, middle, stretch) / (size * size);
    result.mean_square =
      fading * result.mean_square + (1. - fading) * std::pow(std::min(most, result.roughness), 2);
    result.add(stretch);
    return result;
  }


  void GoalEstimate::accept(const State &start, const State &end)
  {
    motion.accept(start, end);
    largest.accept(start, end);
    course_before = course;
    course        = tried;
  }


  void GoalEstimate::take_back()
  {
    motion.take_back();
    largest.take_back();
    course = course_before;
  }


  void GoalEstimate::archive(Archive &archive)
  {
    motion.archive(archive);
    largest.archive(archive);
    archive(course);
  }


  StepRules GoalEstimate::rules() const
  {
    StepRules rules;
    rules.content           = content / of_single_steps;
    rules.worried           = 1. / of_single_steps;
    rules.content_in_flight = 1.;
    rules.rest              = 0;
    rules.smallest_part     = 1. / 8.;
    rules.flight_is_free    = true;
    return rules;
  }
} // namespace signorini
