// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/projected_contact_stabilized.h>
#include <signorini/schemes/projected_predictor.h>
#include <signorini/schemes/stop_held_nodes.h>
#include <signorini/schemes/support_forces.h>

namespace signorini
{
  namespace
  {
    /**
     * Bounds of the predictor: what touches and goes along a hollow does not approach it. 0 is
     * admissible as ever, so that the projection takes energy.
     */
    NormalGap bounds_of_predictor(DynamicalSystem &system,
                                  const Vector    &velocity,
                                  const double     tau,
                                  const NormalGap &gap)
    {
      const double touching = touching_distance(system.length());
      Vector       past     = velocity; // what it faces
      if (const Vector *motion = obstacle_motion(system))
        past.add(-1. / tau, *motion);
      const NormalGap turned = tangential_approach(system, past), now = gaps_at_start(system, gap);
      NormalGap       bounds = gap;
      for (std::size_t k = 0; k < gap.size(); ++k)
        if (now[k] <= touching)
          bounds[k] += tau * turned[k];
      return bounds;
    }


    /** Let something be done with the normals of where an increment ends. */
    template <typename Action>
    auto at_end(DynamicalSystem &system, const Vector &increment, const Action &action)
    {
      MovingContact *contact = system.capabilities().moving_contact;
      if (contact == nullptr || contact->steps_are_trials())
        return action();
      contact->face_end(increment);
      const auto result = action();
      contact->face_motion();
      return result;
    }
  } // namespace


  ProjectedContactStabilized::Motion ProjectedContactStabilized::move(DynamicalSystem &system,
                                                                      const State     &state,
                                                                      const double     tau,
                                                                      const NormalGap &gap)
  {
    Motion      motion;
    SolveReport predictors, correctors;
    // What was in vain is so with normals that are a little different, too, or is looked at anew.
    if (!is_repetition(system))
      lifted.assign(gap.size(), false);
    const NormalGap all_bounds           = bounds_of_predictor(system, state.velocity, tau, gap);
    NormalGap       bounds               = lift_bounds(all_bounds, lifted);
    const Vector    free_right_hand_side = rule.right_hand_side(system, state, tau);
    do
      {
        motion.predictor = project_predictor(system, state, tau, bounds);
        predictors.add(motion.predictor.effort);
        Vector b = free_right_hand_side;
        b += motion.predictor.mass_correction;
        // Friction belongs to all of the normal force, r + M c / tau^2.
        Vector projection_reaction = motion.predictor.mass_correction;
        projection_reaction *= 0.5;
        motion.solution = rule.solve(system, state, tau, b, gap, &projection_reaction);
        correctors.add(motion.solution.effort);
      }
    while (lower_bounds_lifted_in_vain(
             system, motion.solution.increment, gap, all_bounds, lifted, bounds)
           || lift_bounds_stopped_in_vain(
             system, motion.predictor, motion.solution.increment, gap, bounds));
    for (std::size_t k = 0; k < gap.size(); ++k)
      lifted[k] = bounds[k] != all_bounds[k];
    motion.predictor.effort = predictors;
    motion.solution.effort  = correctors;
    return motion;
  }


  TakenStep ProjectedContactStabilized::make_step(DynamicalSystem &system,
                                                  const State     &start,
                                                  const double     tau)
  {
    StepReport               report;
    const NormalGap          gap      = system.normal_gap(start.displacement);
    const Motion             motion   = move(system, start, tau, gap);
    const IncrementSolution &solution = motion.solution;
    const Vector            &p = motion.predictor.increment, &c = motion.predictor.correction,
                 &mass_c = motion.predictor.mass_correction, &d = solution.increment;

    // Prescribed nodes react to the projection, too; what they do is work from outside.
    const Vector dirichlet_force = dirichlet_part(system, mass_c);
    const double projection_work = (mass_c * p - 0.5 * (mass_c * c)) / (tau * tau);
    const double dirichlet_work  = dirichlet_force * p / (tau * tau);
    const double work_of_obstacles =
      (obstacle_work(system, mass_c) - obstacle_work(system, dirichlet_force)) / (tau * tau);

    const double weight = rule.reaction_weight(tau);
    Vector       r      = solution.contact_reaction;
    r *= weight;
    report.predictor      = motion.predictor.effort;
    report.corrector      = solution.effort;
    report.work_obstacles = obstacle_work(system, r);
    report.work_contact   = r * d - report.work_obstacles;
    report.work_predictor = projection_work - dirichlet_work - work_of_obstacles;
    report.work_obstacles += work_of_obstacles;
    report.work_dirichlet = rule.dirichlet_work(solution, tau) + dirichlet_work;
    add_support_force(system, weight, solution.dirichlet_reaction, report);
    add_support_force(system, 1. / (tau * tau), dirichlet_force, report);

    r.add(1. / (tau * tau), mass_c, -1. / (tau * tau), dirichlet_force);

    // v_new - v = c/tau + 2/tau (d - p)
    const Vector change_by_rule  = rule.velocity_change(d, p, tau);
    Vector       velocity_change = change_by_rule;
    velocity_change.add(1. / tau, c);

    // A neighbour that p stops pulls p of a held node below its gap, and leaves v_new.nu =
    // -p.nu/tau there.
    const ActiveSet held =
      staying_nodes(system, gaps_at_start(system, gap), solution, true, stop_sticking_nodes);
    report.work_predictor += at_end(system, d, [&] {
      return stop_held_nodes(system, held, tau, start.velocity, velocity_change, r, report);
    });

    FrictionOfStep friction = friction_of_step(start.friction, solution, weight, r);
    report.work_friction    = friction.work;
    report.work_obstacles += work_of_obstacles_by_friction(system, friction.state);
    State end =
      end_of_step(system, start, tau, d, velocity_change, std::move(r), std::move(friction.state));
    rule.book_dissipation(system, start, end, d, report);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
