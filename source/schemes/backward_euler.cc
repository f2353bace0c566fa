// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/backward_euler.h>
#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  TakenStep BackwardEuler::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    const double end_time = start.time + tau;
    Vector       b        = start.momentum;
    b.sadd(tau, -tau * tau, start.internal_force);
    system.add_load(b, tau * tau, end_time);
    const NormalGap   gap = system.normal_gap(start.displacement);
    IncrementSolution solution;
    system.solve({tau * tau, tau, b, gap, start, tau, tau * tau}, solution);
    const Vector &d = solution.increment;

    Vector r = solution.contact_reaction;
    r /= tau * tau;
    StepReport report;
    report.corrector      = solution.effort;
    report.work_obstacles = obstacle_work(system, r);
    report.work_contact   = r * d - report.work_obstacles;
    report.work_dirichlet = solution.dirichlet_reaction * d / (tau * tau);
    add_support_force(system, 1. / (tau * tau), solution.dirichlet_reaction, report);

    // v_new - v = d/tau - v
    Vector velocity_change = d;
    velocity_change.sadd(1. / tau, -1., start.velocity);
    Vector load_excess = system.make_vector(); // over the mean of both ends
    system.add_load(load_excess, 1., end_time);
    add_mean_load(system, load_excess, -1., start.time, end_time);

    FrictionOfStep friction = friction_of_step(start.friction, solution, 1. / (tau * tau), r);
    report.work_friction    = friction.work;
    report.work_obstacles += work_of_obstacles_by_friction(system, friction.state);
    State end =
      end_of_step(system, start, tau, d, velocity_change, std::move(r), std::move(friction.state));

    Vector mass_times_change = end.momentum, stiffness_times_d = end.internal_force;
    mass_times_change -= start.momentum;
    stiffness_times_d -= start.internal_force;
    report.work_damping = damping_work(system, d, tau);
    report.work_scheme =
      load_excess * d - 0.5 * (mass_times_change * velocity_change + stiffness_times_d * d);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
