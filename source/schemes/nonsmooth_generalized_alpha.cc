// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/schemes/acceleration.h>
#include <signorini/schemes/end_of_step.h>
#include <signorini/schemes/fixed_point.h>
#include <signorini/schemes/nonsmooth_generalized_alpha.h>
#include <signorini/schemes/support_forces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    constexpr double tiny_speed = std::numeric_limits<double>::min(); ///< where nothing moves
    /**
     * Of velocities in the bound, relative to the largest one: the last solution has to be that of
     * its own jump.
     */
    constexpr FixedPoint::Limits jump_limits{1e-9, 1e-9, 100};

    /** Nodes that would penetrate in the middle of the step. */
    std::vector<bool>
    touching_nodes(const DynamicalSystem &system, const State &state, const double tau)
    {
      const NormalGap gap      = system.normal_gap(state.displacement),
                      approach = system.relative_normal(state.velocity);
      std::vector<bool> touching(gap.size());
      for (std::size_t k = 0; k < gap.size(); ++k)
        touching[k] = gap[k] - tau / 2. * approach[k] <= touching_distance(system.length());
      return touching;
    }


    /** jump = W of the impulses of contact. */
    void jump_of_contact(DynamicalSystem         &system,
                         const IncrementSolution &solution,
                         const double             tau,
                         Vector                  &jump)
    {
      jump = system.make_vector();
      if (solution.contact_reaction.linfty_norm() == 0.)
        return;
      Vector impulse = solution.contact_reaction;
      impulse *= 2. / tau;
      jump = system.solve_mass(impulse);
    }
  } // namespace


  IncrementSolution NonsmoothGeneralizedAlpha::solve(DynamicalSystem &system,
                                                     const State     &state,
                                                     const double     tau,
                                                     const Vector    &right_hand_side,
                                                     const Vector    &bound_without_jump,
                                                     Vector          &jump) const
  {
    const std::vector<bool> touching     = touching_nodes(system, state, tau);
    const NormalGap         fixed_bounds = system.relative_normal(bound_without_jump);
    const double            start_speed  = state.velocity.linfty_norm();
    IncrementSolution       solution;
    SolveReport             effort;
    // Iterates gone astray are not the scale of their errors.
    double largest_jump = std::numeric_limits<double>::infinity();

    // The unknowns are the normal jumps at the contact nodes.
    const auto next_jump = [&](const Vector &current, Vector &image) {
      NormalGap bounds(fixed_bounds.size(), std::numeric_limits<double>::infinity());
      for (std::size_t k = 0; k < bounds.size(); ++k)
        if (touching[k])
          bounds[k] =
            fixed_bounds[k] - rule.beta * tau / rule.gamma * epsilon * current.local_element(k);
      system.solve(
        {rule.stiffness_factor(tau), 0., right_hand_side, bounds, state, tau, tau * tau / 2.},
        solution);
      effort.add(solution.effort);
      jump_of_contact(system, solution, tau, jump);

      const NormalGap normal_jump = system.relative_normal(jump);
      image                       = 0.;
      for (std::size_t k = 0; k < bounds.size(); ++k)
        image.local_element(k) = normal_jump[k];
      Vector difference = image;
      difference -= current;
      const double size = std::min(jump.linfty_norm(), largest_jump);
      if (!std::isfinite(largest_jump))
        largest_jump = size;
      return epsilon * difference.linfty_norm() / std::max({start_speed, size, tiny_speed});
    };
    FixedPoint fixed_point(
      next_jump,
      FixedPoint::make_unknowns(touching.size(), state.velocity.get_mpi_communicator()),
      jump_limits);
    fixed_point.run(FixedPoint::usual_depth);
    if (!fixed_point.converged())
      throw StepError("The jumps of the velocity in the step from time "
                      + std::to_string(state.time)
                      + " were not found to nine digits. Choose a smaller Time/Step size, a larger "
                        "Time/Spectral radius or, above 1e-9, a smaller Solver/Tolerance.");
    solution.effort = effort;
    return solution;
  }


  TakenStep NonsmoothGeneralizedAlpha::make_step(DynamicalSystem &system,
                                                 const State     &start,
                                                 const double     tau)
  {
    Assert(tau > 0., dealii::ExcMessage("A step has a positive size."));
    const Vector a      = acceleration_of(system, start, false);
    const Vector d_free = rule.free_increment(start, a, tau);
    const Vector b      = rule.right_hand_side(system, start, a, d_free, tau);

    // d_free - beta tau/gamma (v + tau (1 - gamma) a)
    Vector bound = start.velocity;
    bound.add(tau * (1. - rule.gamma), a);
    bound.sadd(-rule.beta * tau / rule.gamma, 1., d_free);
    Vector                  jump;
    const IncrementSolution solution = solve(system, start, tau, b, bound, jump);
    const Vector           &d        = solution.increment;
    Vector                  r        = solution.contact_reaction; // tau/2 P
    r *= 2. / (tau * tau);

    // a_new = (d - d_free - tau/2 W)/(beta tau^2), v_new - v = tau [(1 - gamma) a + gamma a_new] +
    // W
    Vector a_new = d;
    a_new -= d_free;
    a_new.add(-tau / 2., jump);
    a_new /= rule.beta * tau * tau;
    Vector velocity_change = rule.velocity_change(a, a_new, tau);
    velocity_change += jump;

    // Prescribed nodes react to the jump, too, by an impulse of their own.
    Vector impulse = jump;
    system.apply_mass(impulse, jump);
    impulse                             = dirichlet_part(system, impulse);
    const double dirichlet_impulse_work = impulse * d;
    const double weight                 = rule.reaction_weight(tau);

    StepReport report;
    report.corrector      = solution.effort;
    report.work_contact   = r * d;
    report.work_dirichlet = weight * (solution.dirichlet_reaction * d)
                            + (1. / tau - weight * tau / 2.) * dirichlet_impulse_work;
    add_support_force(system, weight, solution.dirichlet_reaction, report);
    add_support_force(system, 1. / tau - weight * tau / 2., impulse, report);
    State end = end_of_step(system, start, tau, d, velocity_change, std::move(r));
    end.acceleration.swap(a_new);
    report.work_scheme = rule.work(system, start, end, a, d);
    return {std::move(end), std::move(report)};
  }
} // namespace signorini
