// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/acceleration.h>
#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/khenous_laborde_renard.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  namespace
  {
    /**
     * The forces at the start of a step that acceleration and contact do not balance: reactions at
     * prescribed nodes, and in a first step whatever loads massless nodes.
     */
    Vector
    unbalanced_forces(const State &state, const Vector &mass_acceleration, const Vector &load)
    {
      Vector forces = mass_acceleration;
      forces.add(1., state.internal_force, -1., load);
      forces -= state.contact_force;
      return forces;
    }
  } // namespace


  KhenousLabordeRenard::KhenousLabordeRenard(const double beta, const double gamma)
    : beta(beta)
    , gamma(gamma)
  {
  }


  TakenStep
  KhenousLabordeRenard::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    const std::vector<unsigned int> massless = massless_entries(system);
    Vector                          load     = system.make_vector();
    system.add_load(load, 1., start.time);
    const Vector a      = acceleration_of(system, start);
    Vector       mass_a = system.make_vector(), new_load = mass_a;
    system.apply_mass(mass_a, a);
    system.add_load(new_load, 1., start.time + tau);

    // b = M~ [tau v + tau^2 (1/2 - beta) a] + beta tau^2 (f_new - A u)
    const double scale = beta * tau * tau;
    Vector       b     = start.momentum;
    b.sadd(tau, tau * tau * (0.5 - beta), mass_a);
    b.add(scale, new_load, -scale, start.internal_force);

    IncrementSolution solution;
    const NormalGap   gap = system.normal_gap(start.displacement);
    system.solve({scale, 0., b, gap, start, tau, scale}, solution);
    const Vector &d = solution.increment;
    Vector        r = solution.contact_reaction;
    r /= scale;
    Vector a_new = d;
    a_new.add(-tau, start.velocity, -tau * tau * (0.5 - beta), a);
    a_new /= scale;
    for (const unsigned int i : massless)
      a_new.local_element(i) = 0.;
    Vector velocity_change = a;
    velocity_change.sadd(tau * (1. - gamma), tau * gamma, a_new);
    for (const unsigned int i : massless)
      velocity_change.local_element(i) = d.local_element(i) / tau - start.velocity.local_element(i);

    Vector       unbalanced = unbalanced_forces(start, mass_a, load);
    const Vector condition  = dirichlet_part(system, unbalanced);
    unbalanced -= condition;

    StepReport report;
    report.corrector    = solution.effort;
    report.work_contact = (1. - gamma) * (start.contact_force * d) + gamma * (r * d);
    report.work_dirichlet =
      (1. - gamma) * (condition * d) + gamma / scale * (solution.dirichlet_reaction * d);
    add_support_force(system, 1. / scale, solution.dirichlet_reaction, report);

    State end = end_of_step(system, start, tau, d, velocity_change, std::move(r));
    end.acceleration.swap(a_new);

    // What the rule does to the energy: the mean velocity is not d/tau, and forces are not means of
    // both ends.
    Vector momentum_change = end.momentum, stiffness_change = end.internal_force,
           mean_velocity = end.velocity;
    momentum_change -= start.momentum;
    stiffness_change -= start.internal_force;
    mean_velocity += start.velocity;
    mean_velocity.sadd(0.5, -1. / tau, d);
    new_load -= load;
    report.work_scheme = mean_velocity * momentum_change + (1. - gamma) * (unbalanced * d)
                         - (gamma - 0.5) * (stiffness_change * d - new_load * d);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
