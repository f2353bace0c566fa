// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/newmark.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  StepReport Newmark::advance(DynamicalSystem &system, State &state, const double tau)
  {
    // b = tau M v - theta tau^2 (A u - f_theta - (1 - theta) r_n)
    const double theta = rule.theta;
    Vector       b     = rule.right_hand_side(system, state, tau);
    b.add(theta * (1. - theta) * tau * tau, state.contact_force);

    const NormalGap   gap = system.normal_gap(state.displacement);
    IncrementSolution solution;
    // Only theta of the new force enters the balance, hence its square.
    const double factor = theta * theta * tau * tau;
    system.solve({factor, theta * tau, b, gap, state, tau, factor}, solution);
    const Vector &d = solution.increment;

    Vector r = solution.contact_reaction;
    r /= factor;

    StepReport report;
    report.corrector    = solution.effort;
    report.work_contact = (1. - theta) * (state.contact_force * d) + theta * (r * d);
    if (state.friction.any())
      {
        report.work_friction = (1. - theta) * (state.friction.force * d);
        report.work_contact -= report.work_friction;
      }
    FrictionOfStep friction = friction_of_step(state.friction, solution, 1. / factor, r);
    report.work_friction += theta * friction.work;
    report.work_dirichlet = rule.dirichlet_work(solution, tau);
    add_support_force(system, rule.reaction_weight(tau), solution.dirichlet_reaction, report);

    Vector free_increment = state.velocity;
    free_increment *= tau;
    const Vector velocity_change = rule.velocity_change(d, free_increment, tau);
    State        end =
      end_of_step(system, state, tau, d, velocity_change, std::move(r), std::move(friction.state));
    rule.book_dissipation(system, state, end, d, velocity_change, report);
    swap(state, end);
    return report;
  }
} // namespace signorini
