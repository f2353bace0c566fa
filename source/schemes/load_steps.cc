// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/load_steps.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  TakenStep LoadSteps::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    Vector b = system.make_vector();
    system.add_load(b, 1., start.time + tau);
    b -= start.internal_force;
    const NormalGap   gap = system.normal_gap(start.displacement);
    IncrementSolution solution;
    system.capabilities().statics->equilibrate({b, gap, start, tau}, solution);
    const Vector &d = solution.increment;

    Vector unbalanced = start.internal_force; // at the start
    system.add_load(unbalanced, -1., start.time);
    unbalanced -= start.contact_force;
    const Vector support = dirichlet_part(system, unbalanced);
    unbalanced -= support;

    Vector       r                  = solution.contact_reaction;
    const double obstacles_at_start = obstacle_work(system, start.contact_force);
    const double friction_at_start =
      start.friction.any()
        ? start.friction.force * d - work_of_obstacles_by_friction(system, start.friction)
        : 0.;
    StepReport report;
    report.corrector      = solution.effort;
    report.work_obstacles = 0.5 * (obstacles_at_start + obstacle_work(system, r));
    report.work_contact =
      0.5 * (start.contact_force * d - friction_at_start + r * d) - report.work_obstacles;
    report.work_dirichlet = 0.5 * (support * d + solution.dirichlet_reaction * d);
    add_support_force(system, 1., solution.dirichlet_reaction, report);
    FrictionOfStep friction = friction_of_step(start.friction, solution, 1., r);
    report.work_friction    = friction.work;
    report.work_obstacles += 0.5 * work_of_obstacles_by_friction(system, friction.state);
    report.work_scheme = 0.5 * (friction_at_start - friction.work + unbalanced * d)
                         - 0.5 * (start.velocity * start.momentum);

    Vector stop = start.velocity;
    stop *= -1.;
    State end = end_of_step(system, start, tau, d, stop, std::move(r), std::move(friction.state));
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
