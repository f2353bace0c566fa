// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/support_forces.h>
#include <signorini/schemes/trapezoidal_rule.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  double automatic_spectral_radius(const double courant_number)
  {
    const double into_damping = std::log2(std::max(courant_number, 1.) / 40.);
    return 1. - 0.4 * std::clamp(into_damping, 0., 1.);
  }


  Vector TrapezoidalRule::right_hand_side(DynamicalSystem &system,
                                          const State     &state,
                                          const double     tau) const
  {
    Vector result = state.momentum;
    result.sadd(tau, -tau * tau / 2., state.internal_force);
    add_mean_load(system, result, tau * tau / 2., state.time, state.time + tau);
    return result;
  }


  IncrementSolution TrapezoidalRule::solve(DynamicalSystem &system,
                                           const State     &state,
                                           const double     tau,
                                           const Vector    &right_hand_side,
                                           const NormalGap &bounds,
                                           const Vector    *further_reaction) const
  {
    IncrementSolution solution;
    system.solve({stiffness_factor(tau),
                  tau / 2.,
                  right_hand_side,
                  bounds,
                  state,
                  tau,
                  tau * tau / 2.,
                  further_reaction},
                 solution);
    return solution;
  }


  Vector TrapezoidalRule::velocity_change(const Vector &increment,
                                          const Vector &predictor,
                                          const double  tau) const
  {
    Vector result = increment;
    result -= predictor;
    result *= 2. / tau;
    return result;
  }


  double TrapezoidalRule::dirichlet_work(const IncrementSolution &solution, const double tau) const
  {
    return reaction_weight(tau) * (solution.dirichlet_reaction * solution.increment);
  }


  void TrapezoidalRule::book_dissipation(DynamicalSystem &system,
                                         const State     &before,
                                         const State     &after,
                                         const Vector    &increment,
                                         StepReport      &report) const
  {
    report.work_damping = damping_work(system, increment, after.time - before.time);
    if (damping == 0.)
      return;
    Vector stiffness_times_increment = after.internal_force;
    stiffness_times_increment -= before.internal_force;
    report.work_scheme = -damping * (stiffness_times_increment * increment);
  }


  TakenStep TrapezoidalRule::finish_implicit(DynamicalSystem         &system,
                                             const State             &start,
                                             const double             tau,
                                             const IncrementSolution &solution) const
  {
    const Vector &d = solution.increment;
    Vector        r = solution.contact_reaction;
    r *= reaction_weight(tau);

    StepReport report;
    report.corrector      = solution.effort;
    report.work_obstacles = obstacle_work(system, r);
    report.work_contact   = r * d - report.work_obstacles;
    report.work_dirichlet = dirichlet_work(solution, tau);
    add_support_force(system, reaction_weight(tau), solution.dirichlet_reaction, report);

    FrictionOfStep friction = friction_of_step(start.friction, solution, reaction_weight(tau), r);
    report.work_friction    = friction.work;
    report.work_obstacles += work_of_obstacles_by_friction(system, friction.state);

    Vector free_increment = start.velocity;
    free_increment *= tau;
    const Vector change = velocity_change(d, free_increment, tau);
    State end = end_of_step(system, start, tau, d, change, std::move(r), std::move(friction.state));
    book_dissipation(system, start, end, d, report);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
