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
  namespace
  {
    /** Whether bodies that have left each other may meet again: not if they fly apart freely. */
    template <int dim>
    bool contact_may_come_back(const Scene<dim> &scene)
    {
      return scene.pairs.size() > 1
             || std::any_of(scene.bodies.begin(),
                            scene.bodies.end(),
                            [](const auto &body) {
                              return is_given(body.body_force) || !body.dirichlet.empty()
                                     || !body.traction.empty();
                            })
             || std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [](const auto &named) {
                  return named.motion != nullptr;
                });
    }
  } // namespace


  template <int dim>
  std::unique_ptr<TimeStepping>
  make_time_stepping(const Scene<dim>              &scene,
                     TimeScheme                    &scheme,
                     const std::function<double()> &shortest_wave_time,
                     const ForceInStep             &force_in_step)
  {
    const TimeParameters     &time  = scene.time;
    const StepSizeParameters &sizes = scene.step_sizes;
    if (!sizes.is_variable())
      return std::make_unique<FixedSteps>(scheme, time.step_size, time.n_steps());
    std::unique_ptr<StepEstimate> estimate;
    if (sizes.control == StepSizeControl::doubling)
      estimate = std::make_unique<StepDoubling>(scheme);
    else if (sizes.control == StepSizeControl::force)
      estimate = std::make_unique<ForceEstimate>(scheme, time.step_size, dim);
    else if (sizes.control == StepSizeControl::goal)
      estimate = std::make_unique<GoalEstimate>(
        scheme, time.step_size, force_in_step, contact_may_come_back(scene));
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


#define INSTANTIATE(dim)                                                                           \
  template std::unique_ptr<TimeStepping> make_time_stepping(                                       \
    const Scene<dim> &, TimeScheme &, const std::function<double()> &, const ForceInStep &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
