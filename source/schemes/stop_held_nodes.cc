// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/stop_held_nodes.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  ActiveSet staying_nodes(const DynamicalSystem   &system,
                          const NormalGap         &gap,
                          const IncrementSolution &solution,
                          const bool               normal,
                          const bool               tangential)
  {
    const double touching = touching_distance(system.length());
    ActiveSet    held(gap.size(), contact_status::open);
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (gap[k] <= touching && solution.normal_reaction[k] < 0.)
        {
          const bool sticks =
            tangential && !solution.status.empty() && contact_status::sticks(solution.status[k]);
          if (normal)
            held[k] = sticks ? contact_status::stick : contact_status::slip;
          else if (sticks)
            held[k] = contact_status::hang;
        }
    return held;
  }


  double stop_held_nodes(DynamicalSystem &system,
                         const ActiveSet &held,
                         const double     step_size,
                         const Vector    &velocity,
                         Vector          &velocity_change,
                         Vector          &contact_force,
                         StepReport      &report)
  {
    if (is_trial(system))
      return 0.;
    Vector new_velocity = velocity, correction, impulses;
    new_velocity += velocity_change;
    Vector relative_velocity = new_velocity;
    if (const Vector *motion = obstacle_motion(system))
      relative_velocity.add(-1. / step_size, *motion);
    const SolveReport effort = system.capabilities().projections->stop_relative_motion(
      relative_velocity, held, correction, impulses);
    if (effort.n_active == 0)
      return 0.;
    const Vector dirichlet      = dirichlet_part(system, impulses);
    const double work_dirichlet = dirichlet * new_velocity;
    const double work_obstacles =
      (obstacle_work(system, impulses) - obstacle_work(system, dirichlet)) / step_size;
    const double work =
      impulses * new_velocity + 0.5 * (impulses * correction) - work_dirichlet - work_obstacles;

    velocity_change += correction;
    contact_force.add(1. / step_size, impulses, -1. / step_size, dirichlet);
    report.work_dirichlet += work_dirichlet;
    report.work_obstacles += work_obstacles;
    add_support_force(system, 1. / step_size, dirichlet, report);
    report.predictor.linear_iterations += effort.linear_iterations;
    return work;
  }
} // namespace signorini
