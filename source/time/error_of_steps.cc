// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/time/error_of_steps.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  double error_of_step(const ForceOfStep &before, const ForceOfStep &at, const ForceOfStep &after)
  {
    constexpr double of_curvature = 0.6; // measured: doc/step_size.md
    const double     to_before    = at.instant - before.instant;
    const double     to_after     = after.instant - at.instant;
    const double     slope_before = (at.force - before.force) / to_before;
    const double     slope_after  = (after.force - at.force) / to_after;
    const double     both         = to_before + to_after;
    const double     curvature    = 2. * (slope_after - slope_before) / both;
    const double     slope        = (to_before * slope_after + to_after * slope_before) / both;
    // A long flight ends with a kink that it does not see itself.
    const double size = std::min(at.size, after.size);
    return of_curvature * size * size * std::abs(curvature) + at.delay * std::abs(slope);
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
        squared_error += last.size * std::pow(error_of_step(before, last, step), 2);
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
