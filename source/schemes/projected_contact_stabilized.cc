// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/projected_contact_stabilized.h>
#include <signorini/schemes/stop_held_nodes.h>
#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  StepReport
  ProjectedContactStabilized::advance(DynamicalSystem &system, State &state, const double tau)
  {
    StepReport      report;
    const NormalGap gap = system.normal_gap(state.displacement);

    const auto    predictor = trapezoidal_rule::project_predictor(system, state, tau, gap);
    const Vector &p = predictor.increment, &c = predictor.correction,
                 &mass_c = predictor.mass_correction;
    report.predictor     = predictor.effort;

    Vector b = trapezoidal_rule::right_hand_side(system, state, tau);
    b += mass_c;
    // Friction belongs to all of the normal force, r + M c / tau^2.
    Vector projection_reaction = mass_c;
    projection_reaction *= 0.5;
    const IncrementSolution solution =
      trapezoidal_rule::solve(system, state, tau, b, gap, &projection_reaction);
    const Vector &d = solution.increment;

    // Prescribed nodes react to the projection, too; what they do is work from outside.
    const Vector dirichlet_force = dirichlet_part(system, mass_c);
    const double projection_work = (mass_c * p - 0.5 * (mass_c * c)) / (tau * tau);
    const double dirichlet_work  = dirichlet_force * p / (tau * tau);

    Vector r = solution.contact_reaction;
    r *= 2. / (tau * tau);
    report.corrector      = solution.effort;
    report.work_contact   = r * d;
    report.work_predictor = projection_work - dirichlet_work;
    report.work_dirichlet = trapezoidal_rule::dirichlet_work(solution, tau) + dirichlet_work;

    r.add(1. / (tau * tau), mass_c, -1. / (tau * tau), dirichlet_force);

    // v_new - v = c/tau + 2/tau (d - p)
    Vector velocity_change = d;
    velocity_change -= p;
    velocity_change.sadd(2. / tau, 1. / tau, c);

    // A neighbour that p stops pulls p of a held node below its gap, and leaves v_new.nu =
    // -p.nu/tau there.
    const ActiveSet held = staying_nodes(system, gap, solution, true, stop_sticking_nodes);
    report.work_predictor +=
      stop_held_nodes(system, held, tau, state.velocity, velocity_change, r, report);

    FrictionOfStep friction = friction_of_step(state.friction, solution, 2. / (tau * tau), r);
    report.work_friction    = friction.work;
    State end               = trapezoidal_rule::end_of_step(
      system, state, tau, d, velocity_change, std::move(r), std::move(friction.state));
    swap(state, end);
    return report;
  }
} // namespace signorini
