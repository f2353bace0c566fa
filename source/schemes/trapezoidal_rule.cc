// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/friction_of_step.h>
#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  namespace trapezoidal_rule
  {
    Vector right_hand_side(DynamicalSystem &system, const State &state, const double step_size)
    {
      Vector result = state.momentum;
      result.sadd(step_size, -step_size * step_size / 2., state.internal_force);
      add_mean_load(system, result, step_size * step_size / 2., state.time, state.time + step_size);
      return result;
    }


    ProjectedPredictor project_predictor(DynamicalSystem &system,
                                         const State     &state,
                                         const double     step_size,
                                         const NormalGap &gap)
    {
      ProjectedPredictor result;
      result.increment = state.velocity;
      result.increment *= step_size;
      result.effort = system.capabilities().projections->project(
        result.increment, gap, step_size, result.correction, result.mass_correction);
      result.increment += result.correction;
      return result;
    }


    IncrementSolution solve(DynamicalSystem &system,
                            const State     &state,
                            const double     step_size,
                            const Vector    &right_hand_side,
                            const NormalGap &gap,
                            const Vector    *further_reaction)
    {
      const double      square = step_size * step_size;
      IncrementSolution solution;
      system.solve(
        {square / 4., right_hand_side, gap, state, step_size, square / 2., further_reaction},
        solution);
      return solution;
    }


    double dirichlet_work(const IncrementSolution &solution, const double step_size)
    {
      return 2. / (step_size * step_size) * (solution.dirichlet_reaction * solution.increment);
    }


    StepReport finish_implicit(DynamicalSystem         &system,
                               State                   &state,
                               const double             tau,
                               const IncrementSolution &solution)
    {
      const Vector &d = solution.increment;
      Vector        r = solution.contact_reaction;
      r *= 2. / (tau * tau);

      StepReport report;
      report.corrector      = solution.effort;
      report.work_contact   = r * d;
      report.work_dirichlet = dirichlet_work(solution, tau);

      FrictionOfStep friction = friction_of_step(state.friction, solution, 2. / (tau * tau), r);
      report.work_friction    = friction.work;

      Vector velocity_change = d;
      velocity_change.sadd(2. / tau, -2., state.velocity);
      State end = end_of_step(
        system, state, tau, d, velocity_change, std::move(r), std::move(friction.state));
      swap(state, end);
      return report;
    }


    State end_of_step(const DynamicalSystem &system,
                      const State           &start,
                      const double           step_size,
                      const Vector          &increment,
                      const Vector          &velocity_change,
                      Vector               &&contact_force,
                      FrictionState        &&friction)
    {
      State end;
      end.step         = start.step + 1;
      end.time         = start.time + step_size;
      end.displacement = start.displacement;
      end.displacement += increment;
      end.velocity = start.velocity;
      end.velocity += velocity_change;
      end.contact_force.swap(contact_force);
      end.momentum.reinit(start.momentum, true);
      end.internal_force.reinit(start.internal_force, true);
      system.apply_mass(end.momentum, end.velocity);
      system.apply_stiffness(end.internal_force, end.displacement);
      std::swap(end.friction, friction);
      return end;
    }
  } // namespace trapezoidal_rule
} // namespace signorini
