// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/acceleration.h>
#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/generalized_alpha.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  TakenStep
  GeneralizedAlpha::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    const Vector      a      = acceleration_of(system, start);
    const Vector      d_free = rule.free_increment(start, a, tau);
    const Vector      b      = rule.right_hand_side(system, start, a, d_free, tau);
    const NormalGap   gap    = system.normal_gap(start.displacement);
    IncrementSolution solution;
    system.solve(
      {rule.stiffness_factor(tau), 0., b, gap, start, tau, 1. / rule.reaction_weight(tau)},
      solution);
    const Vector &d = solution.increment;
    Vector        r = solution.contact_reaction;
    r *= rule.reaction_weight(tau);

    // a_new = (d - d_free)/(beta tau^2)
    Vector a_new = d;
    a_new -= d_free;
    a_new /= rule.beta * tau * tau;
    Vector velocity_change = rule.velocity_change(a, a_new, tau);

    StepReport report;
    report.corrector      = solution.effort;
    report.work_contact   = r * d;
    report.work_dirichlet = rule.reaction_weight(tau) * (solution.dirichlet_reaction * d);
    add_support_force(system, rule.reaction_weight(tau), solution.dirichlet_reaction, report);
    State end = end_of_step(system, start, tau, d, velocity_change, std::move(r));
    end.acceleration.swap(a_new);
    report.work_scheme = rule.work(system, start, end, a, d);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
