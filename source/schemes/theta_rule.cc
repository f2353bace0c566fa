// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/support_forces.h>
#include <signorini/schemes/theta_rule.h>

namespace signorini
{
  Vector
  ThetaRule::right_hand_side(DynamicalSystem &system, const State &state, const double tau) const
  {
    const double factor = theta * tau * tau;
    Vector       result = state.momentum;
    result.sadd(tau, -factor, state.internal_force);
    system.add_load(result, (1. - theta) * factor, state.time);
    system.add_load(result, theta * factor, state.time + tau);
    return result;
  }


  IncrementSolution ThetaRule::solve(DynamicalSystem &system,
                                     const State     &state,
                                     const double     tau,
                                     const Vector    &right_hand_side,
                                     const NormalGap &bounds,
                                     const Vector    *further_reaction) const
  {
    const double      force_factor = theta * tau * tau;
    IncrementSolution solution;
    system.solve({theta * force_factor,
                  theta * tau,
                  right_hand_side,
                  bounds,
                  state,
                  tau,
                  force_factor,
                  further_reaction},
                 solution);
    return solution;
  }


  Vector ThetaRule::velocity_change(const Vector &increment,
                                    const Vector &predictor,
                                    const double  tau) const
  {
    Vector result = increment;
    result -= predictor;
    result *= 1. / (theta * tau);
    return result;
  }


  double ThetaRule::dirichlet_work(const IncrementSolution &solution, const double tau) const
  {
    return reaction_weight(tau) * (solution.dirichlet_reaction * solution.increment);
  }


  void ThetaRule::book_dissipation(DynamicalSystem &system,
                                   const State     &before,
                                   const State     &after,
                                   const Vector    &increment,
                                   const Vector    &velocity_change,
                                   StepReport      &report) const
  {
    report.work_damping = damping_work(system, increment, after.time - before.time);
    if (theta == 0.5)
      return;
    Vector load_change = system.make_vector();
    system.add_load(load_change, 1., after.time);
    system.add_load(load_change, -1., before.time);
    Vector mass_change = system.make_vector(), stiffness_change = after.internal_force;
    system.apply_mass(mass_change, velocity_change);
    stiffness_change -= before.internal_force;
    report.work_scheme +=
      (theta - 0.5)
      * (load_change * increment - mass_change * velocity_change - stiffness_change * increment);
  }


  StepReport ThetaRule::finish_implicit(DynamicalSystem         &system,
                                        State                   &state,
                                        const double             tau,
                                        const IncrementSolution &solution) const
  {
    const Vector &d = solution.increment;
    Vector        r = solution.contact_reaction;
    r *= reaction_weight(tau);

    StepReport report;
    report.corrector      = solution.effort;
    report.work_contact   = r * d;
    report.work_dirichlet = dirichlet_work(solution, tau);
    add_support_force(system, reaction_weight(tau), solution.dirichlet_reaction, report);

    FrictionOfStep friction = friction_of_step(state.friction, solution, reaction_weight(tau), r);
    report.work_friction    = friction.work;

    Vector free_increment = state.velocity;
    free_increment *= tau;
    const Vector change = velocity_change(d, free_increment, tau);
    State end = end_of_step(system, state, tau, d, change, std::move(r), std::move(friction.state));
    book_dissipation(system, state, end, d, change, report);
    swap(state, end);
    return report;
  }
} // namespace signorini
