// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/time/adaptive_steps.h>
#include <signorini/time/contact_events.h>
#include <signorini/time/energy_norm.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace signorini
{
  namespace
  {
    constexpr double safety    = 0.8;
    constexpr double round_off = 1e-9; ///< of levels and times

    /** Part of the tolerance below which a step of a flight is followed by a longer one. */
    constexpr double content_in_flight = 0.5;

    /** Steps after a rejection that are not lengthened. */
    constexpr unsigned int rest_after_rejection = 8;

    int level_below(const double size, const double first)
    {
      return static_cast<int>(std::floor(std::log2(size / first) + round_off));
    }
  } // namespace


  AdaptiveSteps::AdaptiveSteps(std::unique_ptr<StepEstimate> estimate, const Parameters &parameters)
    : estimate(std::move(estimate))
    , parameters(parameters)
    , lowest(std::min(0, -level_below(parameters.first, parameters.minimum)))
    , highest(std::max(0, level_below(parameters.maximum, parameters.first)))
  {
  }


  AcceptedStep AdaptiveSteps::advance(DynamicalSystem &system, State &state)
  {
    if (waiting)
      {
        TakenStep second = std::move(*waiting);
        waiting.reset();
        return hand_out(state, std::move(second));
      }
    StepTrial trial = find_trial(system, state);
    estimate->accept(state, trial);
    TakenStep &last = trial.steps.back();
    if (parameters.end_time - last.state.time <= round_off * last.step_size)
      last.state.time = parameters.end_time;
    largest_energy = std::max(largest_energy, energy_of_motion(last.state));
    if (trial.steps.size() > 1)
      waiting = std::move(last);
    return hand_out(state, std::move(trial.steps.front()));
  }


  StepTrial AdaptiveSteps::find_trial(DynamicalSystem &system, const State &state)
  {
    largest_energy       = std::max(largest_energy, energy_of_motion(state));
    const double touches = time_to_touch(system, state, 2. * parameters.maximum);
    if (std::isfinite(touches))
      level = std::min(level, touches > 0. ? level_below(touches / 2., parameters.first) : lowest);
    level = std::max(level, lowest);
    rest -= rest > 0;
    for (;;)
      {
        const double tolerance = parameters.tolerance * std::sqrt(largest_energy);
        StepTrial    trial     = estimate->attempt(system, state, span(state), tolerance);
        n_solved += trial.n_solved;
        // A motion that begins at rest is measured by what it becomes.
        const double accepted =
          std::max(tolerance, parameters.tolerance * std::sqrt(energy_of_motion(trial.steps.back().state)));
        const double factor =
          trial.error > 0. ? std::pow(safety * accepted / trial.error, trial.exponent) : 2.; // of the size
        if (trial.error <= accepted || level == lowest)
          {
            // Vibrations that are not resolved have errors as large as themselves, however long the step is.
            const bool content = trial.is_flight && trial.error <= content_in_flight * accepted;
            if ((factor >= 2. || content) && rest == 0 && trial.is_known)
              level = std::min(level + 1, highest);
            return trial;
          }
        ++n_rejected;
        rest  = rest_after_rejection;
        level = std::max(lowest, level + (factor <= 0.25 ? -2 : -1));
      }
  }


  double AdaptiveSteps::span(const State &state) const
  {
    const double size = std::ldexp(parameters.first, level), left = parameters.end_time - state.time;
    // No tiny last step: forces are changes of momentum divided by it.
    if (left <= 1.25 * size)
      return left;
    return left < 2. * size ? left / 2. : size;
  }


  AcceptedStep AdaptiveSteps::hand_out(State &state, TakenStep &&step)
  {
    smallest_size = n_accepted == 0 ? step.step_size : std::min(smallest_size, step.step_size);
    largest_size  = std::max(largest_size, step.step_size);
    ++n_accepted;
    state = std::move(step.state);
    return {step.report, step.step_size};
  }


  double AdaptiveSteps::fraction_done(const State &state) const
  {
    return state.time / parameters.end_time;
  }


  void AdaptiveSteps::forget()
  {
    waiting.reset();
    estimate->forget();
  }


  std::string AdaptiveSteps::summary() const
  {
    std::ostringstream text;
    text << "  steps             " << n_accepted << " accepted, sizes from " << smallest_size << " to " << largest_size
         << "; " << n_rejected << " attempts rejected; " << n_solved << " steps computed for that\n";
    return text.str();
  }
} // namespace signorini
