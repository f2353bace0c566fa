// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/load_steps.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  StepReport LoadSteps::advance(DynamicalSystem &system, State &state, const double tau)
  {
    Vector b = system.make_vector();
    system.add_load(b, 1., state.time + tau);
    b -= state.internal_force;
    const NormalGap   gap = system.normal_gap(state.displacement);
    IncrementSolution solution;
    system.capabilities().statics->equilibrate({b, gap, state, tau}, solution);
    const Vector &d = solution.increment;

    Vector unbalanced = state.internal_force; // at the start
    system.add_load(unbalanced, -1., state.time);
    unbalanced -= state.contact_force;
    const Vector support = dirichlet_part(system, unbalanced);
    unbalanced -= support;

    Vector       r                  = solution.contact_reaction;
    const double obstacles_at_start = obstacle_work(system, state.contact_force);
    const double friction_at_start =
      state.friction.any()
        ? state.friction.force * d - work_of_obstacles_by_friction(system, state.friction)
        : 0.;
    StepReport report;
    report.corrector      = solution.effort;
    report.work_obstacles = 0.5 * (obstacles_at_start + obstacle_work(system, r));
    report.work_contact =
      0.5 * (state.contact_force * d - friction_at_start + r * d) - report.work_obstacles;
    report.work_dirichlet = 0.5 * (support * d + solution.dirichlet_reaction * d);
    add_support_force(system, 1., solution.dirichlet_reaction, report);
    FrictionOfStep friction = friction_of_step(state.friction, solution, 1., r);
    report.work_friction    = friction.work;
    report.work_obstacles += 0.5 * work_of_obstacles_by_friction(system, friction.state);
    report.work_scheme = 0.5 * (friction_at_start - friction.work + unbalanced * d)
                         - 0.5 * (state.velocity * state.momentum);

    Vector stop = state.velocity;
    stop *= -1.;
    State end = end_of_step(system, state, tau, d, stop, std::move(r), std::move(friction.state));
    swap(state, end);
    return report;
  }
} // namespace signorini
