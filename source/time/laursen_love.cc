// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/time/laursen_love.h>
#include <signorini/time/trapezoidal_rule.h>

#include <cmath>

namespace signorini
{
  StepReport LaursenLove::advance(DynamicalSystem &system, State &state, const double tau)
  {
    const Vector            b        = trapezoidal_rule::right_hand_side(system, state, tau);
    const NormalGap         gap      = system.normal_gap(state.displacement);
    const IncrementSolution solution = trapezoidal_rule::solve(system, state, tau, b, gap);
    const Vector           &d        = solution.increment;

    Vector r = solution.contact_reaction;
    r *= 2. / (tau * tau);
    Vector velocity_change = d;
    velocity_change.sadd(2. / tau, -2., state.velocity);

    StepReport report;
    report.corrector    = solution.effort;
    report.work_contact = r * d;
    report.work_support = trapezoidal_rule::support_work(solution, tau);

    if (r.linfty_norm() > 0.)
      {
        // kappa/2 alpha^2 - omega alpha = -r.d with the approach omega = -r.v*, v* the velocity without impulses
        const Vector response = system.solve_mass(r); // M^-1 r
        const double kappa    = r * response;
        const double omega    = -(r * state.velocity + r * velocity_change);
        const double lost     = std::max(0., -report.work_contact);
        double       alpha    = 0.;
        if (kappa > 0. && (omega > 0. || lost > 0.))
          alpha = (omega + std::sqrt(omega * omega + 2. * kappa * lost)) / kappa;
        // Supports react to the impulses; with a velocity of their own that is work from outside.
        Vector impulse = response;
        system.apply_mass(impulse, response);
        impulse = system.support_part(impulse);
        report.work_support += alpha * (impulse * state.velocity + impulse * velocity_change);

        velocity_change.add(alpha, response);
        report.work_contact += alpha * (alpha * kappa / 2. - omega);
        r *= 1. + alpha / tau;
      }
    trapezoidal_rule::finish(system, state, tau, d, velocity_change, std::move(r));
    return report;
  }
} // namespace signorini
