// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/time/error_of_steps.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * Of the error of a force in L2, what the speed after the contact has of it. Measured: bouncing
     * bars and discs, doc/step_size.md.
     */
    constexpr double of_rebound = 0.15;

    /**
     * A flight is as long as its neighbour in contact: of its length the force knows nothing, and
     * the kink where contact begins is that of a step in contact.
     */
    double size_beside(const ForceOfStep &step, const double neighbour)
    {
      return step.force == 0. ? std::min(step.size, neighbour) : step.size;
    }
  } // namespace


  ForceDifferences
  force_differences(const ForceOfStep &before, const ForceOfStep &at, const ForceOfStep &after)
  {
    ForceDifferences result;
    result.size = at.size;
    for (const ForceOfStep *neighbour : {&before, &after})
      if (neighbour->force != 0. && neighbour->size > 0.)
        result.size = std::min(result.size, size_beside(at, neighbour->size));
    const auto distance = [&](const ForceOfStep &other) {
      return std::abs(other.instant - at.instant) * (size_beside(other, result.size) + result.size)
             / (other.size + at.size);
    };
    const double to_before = distance(before), to_after = distance(after);
    if (to_before == 0. || to_after == 0.)
      return result;
    const double slope_before = (at.force - before.force) / to_before;
    const double slope_after  = (after.force - at.force) / to_after;
    const double both         = to_before + to_after;
    result.curvature          = 2. * (slope_after - slope_before) / both;
    result.slope              = (to_before * slope_after + to_after * slope_before) / both;
    return result;
  }


  double error_of_step(const ForceDifferences &force, const double size, const double delay)
  {
    constexpr double of_curvature = 0.6; // measured: doc/step_size.md
    return of_curvature * size * size * std::abs(force.curvature) + delay * std::abs(force.slope);
  }


  void ErrorOfSteps::start(const double time, const double force)
  {
    last   = {time, 0., 0., force};
    before = last;
  }


  void ErrorOfSteps::add(const ForceOfStep &step)
  {
    if (last.size > 0.)
      {
        const ForceDifferences force = force_differences(before, last, step);
        const double error = force.size * std::pow(error_of_step(force, force.size, last.delay), 2);
        squared_error += error;
        squared_force += last.size * std::pow(last.force, 2);
        if (last.force == 0.)
          {
            end_contact();
            late += error_of_impulses * last.size;
          }
        else
          contact.add(last, error, force);
      }
    before = last;
    last   = step;
  }


  void ErrorOfSteps::Contact::add(const ForceOfStep      &step,
                                  const double            error,
                                  const ForceDifferences &force)
  {
    duration += step.size;
    impulse += step.size * std::abs(step.force); // schemes with adhesion pull, too
    squared_error += error;
    squared_force += step.size * std::pow(step.force, 2);
    squared_slope += force.size * std::pow(force.slope, 2);
  }


  void ErrorOfSteps::end_contact()
  {
    if (contact.duration == 0.)
      return;
    squared_error_of_time += error_of_time();
    largest_impulse = std::max(largest_impulse, contact.impulse);
    error_of_impulses +=
      of_rebound * std::sqrt(contact.squared_error / contact.squared_force) * contact.impulse;
    contact = Contact();
  }


  double ErrorOfSteps::error_of_time() const
  {
    if (contact.duration == 0.)
      return 0.;
    // Forces do not differ by more than all of them.
    const double lateness =
      std::min(late / std::max(largest_impulse, contact.impulse), contact.duration / 2.);
    return lateness * lateness * contact.squared_slope;
  }


  double ErrorOfSteps::relative_error() const
  {
    const double all = squared_error + squared_error_of_time + error_of_time();
    return squared_force > 0. ? std::sqrt(all / squared_force) : 0.;
  }
} // namespace signorini
