// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/simulation/make_time_stepping.h>
#include <signorini/step_size/adaptive_steps.h>
#include <signorini/step_size/fixed_steps.h>
#include <signorini/step_size/force_estimate.h>
#include <signorini/step_size/step_doubling.h>

#include <algorithm>

namespace signorini
{
  std::unique_ptr<TimeStepping>
  make_time_stepping(const TimeParameters          &time,
                     const StepSizeParameters      &sizes,
                     TimeScheme                    &scheme,
                     const std::function<double()> &shortest_wave_time,
                     const ForceInStep             &force_in_step)
  {
    if (!sizes.is_variable())
      return std::make_unique<FixedSteps>(scheme, time.step_size, time.n_steps());
    std::unique_ptr<StepEstimate> estimate;
    if (sizes.control == StepSizeControl::doubling)
      estimate = std::make_unique<StepDoubling>(scheme);
    else if (sizes.control == StepSizeControl::force)
      estimate = std::make_unique<ForceEstimate>(scheme, time.step_size);
    else if (sizes.control == StepSizeControl::goal)
      estimate = std::make_unique<GoalEstimate>(scheme, time.step_size, force_in_step);
    else
      estimate = std::make_unique<EmbeddedEstimate>(scheme);
    const double maximum =
      sizes.maximum > 0. ? sizes.maximum : std::max(time.step_size, time.end_time / 10.);
    return std::make_unique<AdaptiveSteps>(std::move(estimate),
                                           AdaptiveSteps::Parameters{sizes.tolerance,
                                                                     time.step_size,
                                                                     sizes.minimum,
                                                                     maximum,
                                                                     time.end_time,
                                                                     shortest_wave_time});
  }
} // namespace signorini
