// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/time/projected_contact_stabilized.h>
#include <signorini/time/trapezoidal_rule.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** The contact nodes that touched before the step and are held at its end. */
    std::vector<char> staying(const DynamicalSystem &system, const NormalGap &gap, const std::vector<double> &reaction)
    {
      const double      touching = 1e-10 * system.length();
      std::vector<char> result(gap.size());
      std::transform(gap.begin(), gap.end(), reaction.begin(), result.begin(), [&](const double g, const double r) {
        return g <= touching && r < 0.;
      });
      return result;
    }
  } // namespace


  StepReport ProjectedContactStabilized::advance(DynamicalSystem &system, State &state, const double tau)
  {
    StepReport      report;
    const NormalGap gap = system.normal_gap(state.displacement);

    const auto    predictor = trapezoidal_rule::project_predictor(system, state, tau, gap);
    const Vector &p = predictor.increment, &c = predictor.correction, &mass_c = predictor.mass_correction;
    report.predictor = predictor.effort;

    Vector b = trapezoidal_rule::right_hand_side(system, state, tau);
    b += mass_c;
    const IncrementSolution solution = trapezoidal_rule::solve(system, state, tau, b, gap);
    const Vector           &d        = solution.increment;

    // Supports react to the projection, too; what they do is work from outside.
    const Vector support_part    = system.support_part(mass_c);
    const double projection_work = (mass_c * p - 0.5 * (mass_c * c)) / (tau * tau);
    const double support_work    = support_part * p / (tau * tau);

    Vector r = solution.contact_reaction;
    r *= 2. / (tau * tau);
    report.corrector      = solution.effort;
    report.work_contact   = r * d;
    report.work_predictor = projection_work - support_work;
    report.work_support   = trapezoidal_rule::support_work(solution, tau) + support_work;

    r.add(1. / (tau * tau), mass_c, -1. / (tau * tau), support_part);

    // v_new - v = c/tau + 2/tau (d - p)
    Vector velocity_change = d;
    velocity_change -= p;
    velocity_change.sadd(2. / tau, 1. / tau, c);

    // A neighbour that p stops pulls p of a held node below its gap, and leaves v_new.nu = -p.nu/tau there.
    Vector v = state.velocity, stop, impulse;
    v += velocity_change;
    const SolveEffort effort =
      system.stop_normal_motion(v, staying(system, gap, solution.normal_reaction), stop, impulse);
    report.predictor.linear_iterations += effort.linear_iterations;
    const Vector support_impulse = system.support_part(impulse);
    report.work_predictor += impulse * v + 0.5 * (impulse * stop) - support_impulse * v;
    report.work_support += support_impulse * v;
    velocity_change += stop;
    r.add(1. / tau, impulse, -1. / tau, support_impulse);
    trapezoidal_rule::finish(system, state, tau, d, velocity_change, std::move(r));
    return report;
  }
} // namespace signorini
