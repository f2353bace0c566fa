// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/newmark.h>
#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  StepReport Newmark::advance(DynamicalSystem &system, State &state, const double tau)
  {
    // b = tau M v - tau^2/2 A u + tau^2/4 r_n
    Vector b = trapezoidal_rule::right_hand_side(system, state, tau);
    b.add(tau * tau / 4., state.contact_force);

    const NormalGap   gap = system.normal_gap(state.displacement);
    IncrementSolution solution;
    // Only half of the new force enters the balance, hence the factor 4 rather than 2.
    system.solve({tau * tau / 4., b, gap, state, tau, tau * tau / 4.}, solution);
    const Vector &d = solution.increment;

    Vector r = solution.contact_reaction;
    r *= 4. / (tau * tau);

    StepReport report;
    report.corrector    = solution.effort;
    report.work_contact = 0.5 * (state.contact_force * d + r * d);
    if (state.friction.any())
      {
        report.work_friction = 0.5 * (state.friction.force * d);
        report.work_contact -= report.work_friction;
      }
    FrictionOfStep friction = friction_of_step(state.friction, solution, 4. / (tau * tau), r);
    report.work_friction += 0.5 * friction.work;
    report.work_dirichlet = trapezoidal_rule::dirichlet_work(solution, tau);

    // v_new - v = 2/tau (d - tau v)
    Vector velocity_change = d;
    velocity_change.sadd(2. / tau, -2., state.velocity);
    State end = trapezoidal_rule::end_of_step(
      system, state, tau, d, velocity_change, std::move(r), std::move(friction.state));
    swap(state, end);
    return report;
  }
} // namespace signorini
