// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/laursen_love.h>
#include <signorini/schemes/node_impulses.h>
#include <signorini/schemes/support_forces.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * The nodal impulses that solve the equations of the single nodes; if that fails, along the
     * contact forces r.
     */
    Vector impulses_per_node(DynamicalSystem         &system,
                             const IncrementSolution &solution,
                             const NormalGap         &gap,
                             const Vector            &velocity,
                             const Vector            &r,
                             const double             weight,
                             StepReport              &report)
    {
      std::vector<double> compression = solution.normal_reaction;
      for (double &force : compression)
        force *= -weight;
      NodeImpulses nodes =
        solve_node_impulses(system, {compression, gap, system.relative_normal(velocity)});
      report.impulse_iterations = nodes.iterations;
      report.common_impulses    = !nodes.converged;
      if (!nodes.converged)
        return r;
      for (double &impulse : nodes.impulses)
        impulse *= -1.;
      return system.capabilities().impulses->normal_forces(nodes.impulses);
    }


    /**
     * Impulses, up to a factor alpha that gives back what contact has taken.
     * @param velocity v*, without impulses
     * @param approach the same relative to obstacles that move
     */
    void give_impulses(DynamicalSystem &system,
                       const Vector    &impulses,
                       const Vector    &velocity,
                       const Vector    &approach,
                       const double     tau,
                       Vector          &r,
                       Vector          &velocity_change,
                       StepReport      &report)
    {
      // kappa/2 alpha^2 - omega alpha = -r.d with the approach omega = -impulses.v*, d and v*
      // relative to obstacles that move
      const Vector response = system.solve_mass(impulses);
      const double kappa    = impulses * response;
      const double omega    = -(impulses * approach);
      const double lost     = std::max(0., -report.work_contact);
      double       alpha    = 0.;
      if (kappa > 0. && (omega > 0. || lost > 0.))
        alpha = (omega + std::sqrt(omega * omega + 2. * kappa * lost)) / kappa;
      // Prescribed nodes react to the impulses; with a velocity of their own that is work from
      // outside.
      Vector reaction = response;
      system.apply_mass(reaction, response);
      const Vector dirichlet = dirichlet_part(system, reaction);
      report.work_dirichlet += alpha * (dirichlet * velocity);
      add_support_force(system, alpha / tau, dirichlet, report);

      velocity_change.add(alpha, response);
      report.work_contact += alpha * (alpha * kappa / 2. - omega);
      report.work_obstacles += alpha / tau * obstacle_work(system, impulses);
      r.add(alpha / tau, impulses);
    }
  } // namespace


  TakenStep LaursenLove::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    const Vector            b        = rule.right_hand_side(system, start, tau);
    const NormalGap         gap      = system.normal_gap(start.displacement);
    const IncrementSolution solution = rule.solve(system, start, tau, b, gap);
    const Vector           &d        = solution.increment;

    Vector       r      = solution.contact_reaction;
    const double weight = rule.reaction_weight(tau);
    r *= weight;
    Vector free_increment = start.velocity;
    free_increment *= tau;
    const Vector change_by_rule  = rule.velocity_change(d, free_increment, tau);
    Vector       velocity_change = change_by_rule;

    StepReport report;
    report.corrector      = solution.effort;
    report.work_obstacles = obstacle_work(system, r);
    report.work_contact   = r * d - report.work_obstacles;
    report.work_dirichlet = rule.dirichlet_work(solution, tau);
    add_support_force(system, weight, solution.dirichlet_reaction, report);

    if (r.linfty_norm() > 0.)
      {
        Vector velocity = start.velocity; // v*, without impulses
        velocity += velocity_change;
        Vector approach = velocity;
        if (const Vector *motion = obstacle_motion(system))
          approach.add(-1. / tau, *motion);
        const NormalGap gaps = gaps_at_start(system, gap);
        const Vector    impulses =
          separate_nodes ? impulses_per_node(system, solution, gaps, approach, r, weight, report)
                            : r; // up to a factor
        give_impulses(system, impulses, velocity, approach, tau, r, velocity_change, report);
      }
    FrictionOfStep friction = friction_of_step(start.friction, solution, weight, r);
    report.work_friction    = friction.work;
    report.work_obstacles += work_of_obstacles_by_friction(system, friction.state);
    State end =
      end_of_step(system, start, tau, d, velocity_change, std::move(r), std::move(friction.state));
    rule.book_dissipation(system, start, end, d, report);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
