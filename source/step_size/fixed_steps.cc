// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/step_size/fixed_steps.h>

#include <cmath>

namespace signorini
{
  std::int64_t FixedSteps::parts_done(const State &state) const
  {
    // The round-off of a sum of a million steps is far below half a part.
    return std::llround(state.time / step_size * smallest_parts);
  }


  StepReport FixedSteps::advance(DynamicalSystem &system, State &state)
  {
    const std::int64_t done  = parts_done(state);
    std::int64_t       parts = smallest_parts;
    while (done % parts != 0)
      parts /= 2;
    for (unsigned int rejected = 0;; ++rejected)
      try
        {
          const double size =
            parts == smallest_parts ? step_size : step_size * parts / smallest_parts;
          TakenStep step             = take_step(scheme, system, state, size);
          step.report.rejected_steps = rejected;
          swap(state, step.state);
          return std::move(step.report);
        }
      catch (const StepError &error)
        {
          if (parts == 1)
            throw given_up(error, state.time, step_size / smallest_parts);
          parts /= 2;
        }
  }


  double FixedSteps::fraction_done(const State &state) const
  {
    return static_cast<double>(parts_done(state)) / (smallest_parts * n_steps);
  }
} // namespace signorini
