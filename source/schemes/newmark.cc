// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/newmark.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  TakenStep Newmark::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    // b = tau M v - tau^2/2 A u + tau^2/4 r_n
    Vector b = rule.right_hand_side(system, start, tau);
    b.add(tau * tau / 4., start.contact_force);

    const NormalGap   gap = system.normal_gap(start.displacement);
    IncrementSolution solution;
    // Only half of the new force enters the balance, hence the factor 4 rather than 2.
    const double force_factor = tau * tau / 4.;
    system.solve({rule.stiffness_factor(tau), tau / 2., b, gap, start, tau, force_factor},
                 solution);
    const Vector &d = solution.increment;

    Vector r = solution.contact_reaction;
    r /= force_factor;

    StepReport report;
    report.corrector    = solution.effort;
    report.work_contact = 0.5 * (start.contact_force * d + r * d);
    if (start.friction.any())
      {
        report.work_friction = 0.5 * (start.friction.force * d);
        report.work_contact -= report.work_friction;
      }
    FrictionOfStep friction = friction_of_step(start.friction, solution, 1. / force_factor, r);
    report.work_friction += 0.5 * friction.work;
    report.work_dirichlet = rule.dirichlet_work(solution, tau);
    add_support_force(system, rule.reaction_weight(tau), solution.dirichlet_reaction, report);

    Vector free_increment = start.velocity;
    free_increment *= tau;
    const Vector velocity_change = rule.velocity_change(d, free_increment, tau);
    State        end =
      end_of_step(system, start, tau, d, velocity_change, std::move(r), std::move(friction.state));
    rule.book_dissipation(system, start, end, d, report);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
