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
        squared_error += force.size * std::pow(error_of_step(force, force.size, last.delay), 2);
        squared_force += last.size * std::pow(last.force, 2);
      }
    before = last;
    last   = step;
  }


  double ErrorOfSteps::relative_error() const
  {
    return squared_force > 0. ? std::sqrt(squared_error / squared_force) : 0.;
  }
} // namespace signorini
