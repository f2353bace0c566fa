// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/schemes/first_acceleration.h>
#include <signorini/schemes/nonsmooth_generalized_alpha.h>
#include <signorini/schemes/trapezoidal_rule.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  namespace
  {
    constexpr unsigned int maximum_jump_iterations = 100;
    constexpr double       jump_tolerance          = 1e-9; ///< of velocities in the bound, relative to the largest one

    /** Nodes that would penetrate in the middle of the step. */
    std::vector<bool> touching_nodes(const DynamicalSystem &system, const State &state, const double tau)
    {
      const NormalGap   gap = system.normal_gap(state.displacement), approach = system.relative_normal(state.velocity);
      std::vector<bool> touching(gap.size());
      for (std::size_t k = 0; k < gap.size(); ++k)
        touching[k] = gap[k] - tau / 2. * approach[k] <= touching_distance(system.length());
      return touching;
    }
  } // namespace


  IncrementSolution NonsmoothGeneralizedAlpha::solve(DynamicalSystem &system,
                                                     const State     &state,
                                                     const double     tau,
                                                     const Vector    &right_hand_side,
                                                     const Vector    &bound_without_jump,
                                                     Vector          &jump) const
  {
    const std::vector<bool> touching = touching_nodes(system, state, tau);
    IncrementSolution       solution;
    SolveEffort             effort;
    Vector                  guess      = system.make_vector(), last_difference;
    double                  relaxation = 1.;
    for (unsigned int iteration = 0; iteration < maximum_jump_iterations; ++iteration)
      {
        Vector bound = bound_without_jump;
        bound.add(-rule.beta * tau / rule.gamma * epsilon, guess);
        NormalGap bounds = system.relative_normal(bound);
        for (std::size_t k = 0; k < bounds.size(); ++k)
          if (!touching[k])
            bounds[k] = std::numeric_limits<double>::infinity();

        system.solve({rule.stiffness_factor(tau), right_hand_side, bounds, state, tau, tau * tau / 2.}, solution);
        effort.active_set_iterations += solution.effort.active_set_iterations;
        effort.linear_iterations += solution.effort.linear_iterations;
        effort.fallback    = effort.fallback || solution.effort.fallback;
        effort.n_active    = solution.effort.n_active;
        solution.effort    = effort;
        jump               = system.make_vector();
        const bool pushes  = solution.contact_reaction.linfty_norm() > 0.;
        Vector     impulse = solution.contact_reaction;
        impulse *= 2. / tau;
        if (pushes)
          jump = system.solve_mass(impulse);

        Vector difference = jump;
        difference -= guess;
        const double speed = std::max(state.velocity.linfty_norm(), jump.linfty_norm());
        if (epsilon * difference.linfty_norm() <= jump_tolerance * speed)
          return solution;
        if (iteration > 0)
          {
            // Aitken: the step that a linear problem of one unknown would need
            Vector decrease = last_difference;
            decrease -= difference;
            const double relaxed = relaxation * (last_difference * decrease) / (decrease * decrease);
            relaxation           = std::min(1., std::max(1e-3, relaxed));
          }
        guess.add(relaxation, difference);
        last_difference = difference;
      }
    throw RunError("The jumps of the velocity in the step from time " + std::to_string(state.time)
                   + " were not found. Choose a smaller Time/Step size or a larger Time/Spectral radius.");
  }


  StepReport NonsmoothGeneralizedAlpha::advance(DynamicalSystem &system, State &state, const double tau)
  {
    const Vector a      = state.acceleration.size() > 0 ? state.acceleration : first_acceleration(system, state, false);
    const Vector d_free = rule.free_increment(state, a, tau);
    const Vector b      = rule.right_hand_side(system, state, a, d_free, tau);

    // d_free - beta tau/gamma (v + tau (1 - gamma) a)
    Vector bound = state.velocity;
    bound.add(tau * (1. - rule.gamma), a);
    bound.sadd(-rule.beta * tau / rule.gamma, 1., d_free);
    Vector                  jump;
    const IncrementSolution solution = solve(system, state, tau, b, bound, jump);
    const Vector           &d        = solution.increment;
    Vector                  r        = solution.contact_reaction; // tau/2 P
    r *= 2. / (tau * tau);

    // a_new = (d - d_free - tau/2 W)/(beta tau^2), v_new - v = tau [(1 - gamma) a + gamma a_new] + W
    Vector a_new = d;
    a_new -= d_free;
    a_new.add(-tau / 2., jump);
    a_new /= rule.beta * tau * tau;
    Vector velocity_change = rule.velocity_change(a, a_new, tau);
    velocity_change += jump;

    // Supports react to the jump, too, by an impulse of their own.
    Vector impulse = jump;
    system.apply_mass(impulse, jump);
    impulse                           = support_part(system, impulse);
    const double support_impulse_work = impulse * d;
    const double weight               = rule.reaction_weight(tau);

    StepReport report;
    report.corrector    = solution.effort;
    report.work_contact = r * d;
    report.work_support =
      weight * (solution.support_reaction * d) + (1. / tau - weight * tau / 2.) * support_impulse_work;
    State end = trapezoidal_rule::end_of_step(system, state, tau, d, velocity_change, std::move(r));
    end.acceleration.swap(a_new);
    report.work_scheme = AlphaRule::work(system, state, end, d, report);
    swap(state, end);
    return report;
  }
} // namespace signorini
