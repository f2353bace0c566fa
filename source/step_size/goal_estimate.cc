// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/contact_events.h>
#include <signorini/step_size/goal_estimate.h>

#include <deal.II/base/mpi.h>

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
    constexpr double content = 0.2, hinders = 0.5;

    /**
     * The error of a single step may be so many times that of all of them together: that of a kink
     * is, and does not matter in the mean.
     */
    constexpr double of_single_steps = 2.;

    /**
     * Of the embedded estimate, what vibrations lose of their phase in a radian, as part of their
     * amplitude: with the angle w = omega tau of a step the estimate is w^2, and the trapezoidal
     * rule is late by w^3/12.
     */
    constexpr double of_radian = 1. / 12.;
    /** What of this is left for the next step: vibrations change their velocity little where they
     * turn. */
    constexpr double lasting = 0.9;

    /** As in the column contact_force of history.csv, of all processes. */
    double contact_force(const DynamicalSystem &system, const State &state)
    {
      double sum = 0.;
      for (const double force : system.own_normal_forces(state.contact_force))
        sum += std::abs(force);
      return dealii::Utilities::MPI::sum(sum, state.contact_force.get_mpi_communicator());
    }
  } // namespace


  StepTrial GoalEstimate::attempt(DynamicalSystem &system,
                                  const State     &start,
                                  const double     span,
                                  const double     tolerance)
  {
    StepTrial    trial  = motion.attempt(system, start, span, tolerance);
    const State &end    = trial.steps.back().state;
    trial.is_flight     = !any_contact(trial.end_statuses, end.displacement);
    trial.exponent      = 0.5;
    const double before = contact_force(system, start);
    force_at_end        = contact_force(system, end);
    const double larger = std::max(before, force_at_end);
    if (larger == 0.)
      {
        tried             = with(start, end, before, 0.);
        tried.mean_square = 0.;
        tried.waves       = std::max(trial.error / (span * span), lasting * course.waves);
        trial.is_free     = trial.is_flight && (!comes_back || tried.waves == 0.);
        trial.error =
          comes_back ? of_waves(of_radian * tried.waves * span * span, span, tolerance) : 0.;
        return trial;
      }
    const double waves  = of_waves(std::pow(trial.error, 2), span, tolerance);
    const double unit   = span * span / largest.expected(start, end, larger);
    tried               = with(start, end, before, of_single_steps * tolerance / unit);
    tried.waves         = 0.;
    const bool   is_new = tried.present.size == 0.; // a stretch is complete
    const double usual  = std::sqrt(tried.mean_square) * unit;
    const double latest = is_new ? tried.roughness * unit : 0.;
    trial.is_known      = is_new;
    trial.error = std::max({usual, waves, latest > of_single_steps * tolerance ? latest : 0.});
    trial.error /= of_single_steps;
    return trial;
  }


  double GoalEstimate::of_waves(const double error, const double span, const double tolerance) const
  {
    if (span < nearly * first)
      return 0.;
    return span < nearly * 2. * first ? std::min(error, hinders * tolerance) : error;
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


  GoalEstimate::Course GoalEstimate::with(const State &start,
                                          const State &end,
                                          const double force_before,
                                          const double most) const
  {
    const double size   = end.time - start.time;
    Course       result = course;
    if (result.last.size == 0.)
      result.begin(start.time, first, force_before);
    ForceOfStep &sums = result.present;
    sums.size += size;
    sums.instant += size * (end.time - force_in_step.before_end * size);
    sums.force += size * force_at_end;
    if (sums.size < nearly * first)
      return result;
    const ForceOfStep      stretch{sums.instant / sums.size, sums.size, 0., sums.force / sums.size};
    const ForceDifferences force = force_differences(result.before, result.last, stretch);
    result.roughness = error_of_step(force, size, force_in_step.delay() * size) / (size * size);
    result.mean_square =
      fading * result.mean_square + (1. - fading) * std::pow(std::min(most, result.roughness), 2);
    result.add(stretch);
    return result;
  }


  void GoalEstimate::accept(const State &start, const State &end)
  {
    motion.accept(start, end);
    largest.accept(start, end, force_at_end);
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
    rules.content            = content / of_single_steps;
    rules.worried            = 1. / of_single_steps;
    rules.trusts_power       = false;
    rules.enough_for_impacts = 0.;
    rules.key_of_tolerance   = "Adaptivity/Target error";
    rules.content_in_flight  = 0.25;
    rules.wave_part          = 2.; // shorter ones make contact ring with the smallest cells
    rules.rest               = 0;
    rules.smallest_part      = 1. / 8.;
    rules.flight_is_free     = true;
    return rules;
  }
} // namespace signorini
