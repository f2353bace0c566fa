// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/time/trapezoidal_rule.h>

namespace signorini
{
  namespace trapezoidal_rule
  {
    Vector right_hand_side(DynamicalSystem &system, const State &state, const double step_size)
    {
      Vector result = state.momentum;
      result.sadd(step_size, -step_size * step_size / 2., state.internal_force);
      system.add_mean_load(result, step_size * step_size / 2., state.time, state.time + step_size);
      return result;
    }


    ProjectedPredictor
    project_predictor(DynamicalSystem &system, const State &state, const double step_size, const NormalGap &gap)
    {
      ProjectedPredictor result;
      result.increment = state.velocity;
      result.increment *= step_size;
      result.effort = system.project(result.increment, gap, step_size, result.correction, result.mass_correction);
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
        {square / 4., right_hand_side, gap, state.displacement, state.time, step_size, square / 2., further_reaction},
        solution);
      return solution;
    }


    double record_friction(State &state, const IncrementSolution &solution, const double factor, Vector &contact_force)
    {
      if (solution.friction_reaction.size() == 0)
        return 0.;
      FrictionState &friction = state.friction;
      if (!friction.any())
        {
          friction.accumulated_slip.reinit(solution.slip);
          friction.slip_path.assign(solution.slip_length.size(), 0.);
        }
      friction.force = solution.friction_reaction;
      friction.force *= factor;
      contact_force += friction.force;
      friction.status = solution.status;
      friction.slip   = solution.slip;
      friction.accumulated_slip += solution.slip;
      for (std::size_t k = 0; k < friction.slip_path.size(); ++k)
        friction.slip_path[k] += solution.slip_length[k];
      return factor * solution.friction_work;
    }


    StoppedVelocity stop(DynamicalSystem &system, const Vector &velocity, const ActiveSet &held)
    {
      StoppedVelocity result;
      result.effort = system.stop_relative_motion(velocity, held, result.correction, result.mass_correction);
      if (result.effort.n_active == 0)
        return result;
      const Vector supports = system.support_part(result.mass_correction);
      result.work_support   = supports * velocity;
      result.work           = result.mass_correction * velocity + 0.5 * (result.mass_correction * result.correction);
      result.work -= result.work_support;
      result.mass_correction -= supports;
      return result;
    }


    ActiveSet staying_nodes(const DynamicalSystem   &system,
                            const NormalGap         &gap,
                            const IncrementSolution &solution,
                            const bool               normal,
                            const bool               tangential)
    {
      const double touching = 1e-10 * system.length();
      ActiveSet    held(gap.size(), contact_status::open);
      for (std::size_t k = 0; k < gap.size(); ++k)
        if (gap[k] <= touching && solution.normal_reaction[k] < 0.)
          {
            const bool sticks = tangential && !solution.status.empty() && contact_status::sticks(solution.status[k]);
            if (normal)
              held[k] = sticks ? contact_status::stick : contact_status::slip;
            else if (sticks)
              held[k] = contact_status::hang;
          }
      return held;
    }


    double support_work(const IncrementSolution &solution, const double step_size)
    {
      return 2. / (step_size * step_size) * (solution.support_reaction * solution.increment);
    }


    StepReport
    finish_implicit(const DynamicalSystem &system, State &state, const double tau, const IncrementSolution &solution)
    {
      const Vector &d = solution.increment;
      Vector        r = solution.contact_reaction;
      r *= 2. / (tau * tau);

      StepReport report;
      report.corrector    = solution.effort;
      report.work_contact = r * d;
      report.work_support = support_work(solution, tau);

      report.work_friction = record_friction(state, solution, 2. / (tau * tau), r);

      Vector velocity_change = d;
      velocity_change.sadd(2. / tau, -2., state.velocity);
      finish(system, state, tau, d, velocity_change, std::move(r));
      return report;
    }


    void finish(const DynamicalSystem &system,
                State                 &state,
                const double           step_size,
                const Vector          &increment,
                const Vector          &velocity_change,
                Vector               &&contact_force)
    {
      state.displacement += increment;
      state.velocity += velocity_change;
      state.contact_force = std::move(contact_force);
      state.time += step_size;
      ++state.step;
      system.apply_mass(state.momentum, state.velocity);
      system.apply_stiffness(state.internal_force, state.displacement);
    }
  } // namespace trapezoidal_rule
} // namespace signorini
