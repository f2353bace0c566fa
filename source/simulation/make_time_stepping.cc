// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/simulation/make_time_stepping.h>
#include <signorini/time/adaptive_steps.h>
#include <signorini/time/force_estimate.h>
#include <signorini/time/step_doubling.h>

#include <algorithm>

namespace signorini
{
  std::unique_ptr<TimeStepping> make_time_stepping(const TimeParameters     &time,
                                                   const StepSizeParameters &sizes,
                                                   TimeScheme               &scheme,
                                                   const DynamicalSystem    &system)
  {
    if (!sizes.is_variable())
      return std::make_unique<FixedSteps>(scheme, time.step_size, time.n_steps());
    std::unique_ptr<StepEstimate> estimate;
    double                        resolved = system.shortest_wave_time() / 2.;
    if (sizes.control == "doubling")
      {
        estimate = std::make_unique<StepDoubling>(scheme);
        resolved *= 2.; // the halves are what counts
      }
    else if (sizes.control == "force")
      estimate = std::make_unique<ForceEstimate>(scheme, time.step_size);
    else
      estimate = std::make_unique<EmbeddedEstimate>(scheme);
    const double minimum = sizes.minimum > 0. ? sizes.minimum : std::min(time.step_size, resolved);
    const double maximum = sizes.maximum > 0. ? sizes.maximum : std::max(time.step_size, time.end_time / 10.);
    return std::make_unique<AdaptiveSteps>(
      std::move(estimate), AdaptiveSteps::Parameters{sizes.tolerance, time.step_size, minimum, maximum, time.end_time});
  }
} // namespace signorini
