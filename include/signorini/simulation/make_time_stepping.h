// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_make_time_stepping_h
#define signorini_simulation_make_time_stepping_h

#include <signorini/scene/scene.h>
#include <signorini/step_size/goal_estimate.h>
#include <signorini/step_size/time_stepping.h>

#include <functional>
#include <memory>

namespace signorini
{
  /**
   * The steps that a scene asks for. The scheme must outlive the result.
   * @param shortest_wave_time through the smallest cell of the present mesh: much shorter steps
   *                           gain nothing
   * @param force_in_step      of the scheme
   */
  template <int dim>
  std::unique_ptr<TimeStepping>
  make_time_stepping(const Scene<dim>              &scene,
                     TimeScheme                    &scheme,
                     const std::function<double()> &shortest_wave_time,
                     const ForceInStep             &force_in_step);
} // namespace signorini

#endif
