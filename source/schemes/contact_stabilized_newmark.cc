// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/contact_stabilized_newmark.h>
#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/projected_predictor.h>
#include <signorini/schemes/stop_held_nodes.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  TakenStep
  ContactStabilizedNewmark::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    StepReport      report;
    const NormalGap gap = system.normal_gap(start.displacement);

    // (36): p = tau v + c, the L2 projection of the free increment
    const auto    predictor = project_predictor(system, start, tau, gap);
    const Vector &p = predictor.increment, &mass_c = predictor.mass_correction;
    report.predictor = predictor.effort;

    // (37): (M + tau^2/4 A) d = M p - tau^2/2 A u + tau^2/2 r
    Vector b = rule.right_hand_side(system, start, tau);
    b += mass_c;
    const IncrementSolution solution = rule.solve(system, start, tau, b, gap);
    const Vector           &d        = solution.increment;

    const double weight = rule.reaction_weight(tau);
    Vector       r      = solution.contact_reaction;
    r *= weight;

    // (38): v_new = v + 2/tau (d - p)
    Vector velocity_change = rule.velocity_change(d, p, tau);

    // (39): E_new - E = r.d + 2/tau^2 (tau v - p)'M(d - p). Prescribed nodes that accelerate react
    // to the projection, too; their part of the second term is work from outside, and only the rest
    // has a sign.
    const double projection_work = -(mass_c * velocity_change) / tau;
    const double dirichlet_work  = -(dirichlet_part(system, mass_c) * velocity_change) / tau;

    report.corrector      = solution.effort;
    report.work_obstacles = obstacle_work(system, r);
    report.work_contact   = r * d - report.work_obstacles;
    report.work_predictor = projection_work - dirichlet_work;
    report.work_dirichlet = rule.dirichlet_work(solution, tau) + dirichlet_work;
    add_support_force(system, weight, solution.dirichlet_reaction, report);

    FrictionOfStep friction = friction_of_step(start.friction, solution, weight, r);
    report.work_friction    = friction.work;
    report.work_obstacles += work_of_obstacles_by_friction(system, friction.state);
    if (stop_sticking_nodes && friction.state.any())
      {
        const ActiveSet sticking =
          staying_nodes(system, gaps_at_start(system, gap), solution, false, true);
        report.work_friction +=
          stop_held_nodes(system, sticking, tau, start.velocity, velocity_change, r, report);
      }
    State end =
      end_of_step(system, start, tau, d, velocity_change, std::move(r), std::move(friction.state));
    rule.book_dissipation(system, start, end, d, report);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
