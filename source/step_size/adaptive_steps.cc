// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/step_size/adaptive_steps.h>
#include <signorini/step_size/contact_events.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace signorini
{
  namespace
  {
    constexpr double safety    = 0.8;
    constexpr double round_off = 1e-9; ///< of levels and times
    /**
     * In flight, of the time to the touch: half, and a little more, because a touch is often a
     * whole number of steps away, and round-off would decide whether a step is half of that.
     */
    constexpr double part_of_approach = 9. / 16.;
    /** Steps end this part of their size, or of the first size, before or after a touch. */
    constexpr double clear_of_touch = 1. / 8.;

    /**
     * Trials in sequence that are accepted at the smallest size in spite of their errors. A shock
     * has some: nodes close and open. More of them are a tolerance that cannot be met.
     */
    constexpr unsigned int many_inaccurate = 20;

    int level_below(const double size, const double first)
    {
      return static_cast<int>(std::floor(std::log2(size / first) + round_off));
    }
  } // namespace


  AdaptiveSteps::AdaptiveSteps(std::unique_ptr<StepEstimate> estimate, const Parameters &parameters)
    : estimate(std::move(estimate))
    , parameters(parameters)
    , rules(this->estimate->rules())
    , highest(std::max(0, level_below(parameters.maximum, parameters.first)))
  {
  }


  StepReport AdaptiveSteps::advance(DynamicalSystem &system, State &state)
  {
    before = now;
    if (waiting)
      {
        TakenStep second = std::move(*waiting);
        waiting.reset();
        return hand_out_one_of_several(system, state, std::move(second));
      }
    StepTrial trial = find_trial_or_forget_it(system, state);
    record_changes(state, trial);
    TakenStep &last = trial.steps.back();
    if (parameters.end_time - last.state.time <= round_off * last.report.step_size)
      last.state.time = parameters.end_time;
    if (trial.steps.size() == 1)
      return hand_out(state, std::move(last));
    waiting = std::move(last);
    return hand_out_one_of_several(system, state, std::move(trial.steps.front()));
  }


  StepTrial AdaptiveSteps::find_trial_or_forget_it(DynamicalSystem &system, const State &state)
  {
    try
      {
        return find_trial(system, state);
      }
    catch (...) // a run that goes on from here tries the same sizes
      {
        now = before;
        throw;
      }
  }


  double AdaptiveSteps::minimum() const
  {
    if (parameters.minimum > 0.)
      return parameters.minimum;
    const double wave_time = parameters.shortest_wave_time ? parameters.shortest_wave_time() : 0.;
    const double resolved  = rules.wave_part * wave_time;
    return std::min(parameters.first, std::max(resolved, rules.smallest_part * parameters.first));
  }


  void AdaptiveSteps::approach(const double touch)
  {
    if (!std::isfinite(touch))
      return;
    // Touches that matter are found by their forces, and those of vibrating nodes should not hold
    // up a flight.
    const double reach =
      rules.flight_is_free ? touch - clear_of_touch * parameters.first : part_of_approach * touch;
    const int shortest = rules.flight_is_free ? std::max(lowest, std::min(now.level, 0)) : lowest;
    const int reached  = reach > 0. ? level_below(reach, parameters.first) : lowest;
    now.level          = std::min(now.level, std::max(reached, shortest));
  }


  void AdaptiveSteps::count(const StepTrial &trial, const State &state)
  {
    ++now.n_trials;
    if (trial.error <= parameters.tolerance)
      {
        now.n_inaccurate_now = 0;
        return;
      }
    ++now.n_inaccurate;
    if (now.n_inaccurate_now++ == 0 && !has_said_inaccurate)
      inaccurate_since = state.time;
    says_inaccurate |= now.n_inaccurate_now == many_inaccurate && !has_said_inaccurate;
  }


  void AdaptiveSteps::choose_next_size(const StepTrial &trial, const double factor)
  {
    if (trial.error > rules.worried * parameters.tolerance && now.level > lowest)
      --now.level;
    if (now.rest > 0 || !trial.is_known)
      return;
    if (trial.is_free)
      {
        now.level = highest;
        return;
      }
    // Vibrations that are not resolved have errors as large as themselves, however long the step
    // is.
    const double content = trial.is_flight ? rules.content_in_flight : rules.content;
    if ((rules.trusts_power && factor >= 2.) || trial.error <= content * parameters.tolerance)
      now.level = std::min(now.level + 1, highest);
  }


  StepTrial AdaptiveSteps::find_trial(DynamicalSystem &system, const State &state)
  {
    if (new_mesh)
      lowest = std::min(0, -level_below(parameters.first, minimum()));
    new_mesh = false;
    // What is farther away than two steps does not matter yet.
    now.level          = std::max(now.level, lowest);
    const double size  = std::ldexp(parameters.first, now.level);
    const double touch = time_to_touch(system, state, 2. * size);
    approach(touch);
    now.rest -= now.rest > 0;
    for (unsigned int rejected = 0;; ++rejected)
      {
        std::optional<StepTrial> trial = attempt(system, state, span(state, touch));
        if (!trial)
          {
            reject(1);
            continue;
          }
        const double factor =
          trial->error > 0.
            ? std::pow(safety * parameters.tolerance / trial->error, trial->exponent)
            : 2.; // of the size
        if (trial->error <= parameters.tolerance || now.level <= lowest)
          {
            count(*trial, state);
            choose_next_size(*trial, factor);
            trial->steps.front().report.rejected_steps = rejected;
            return std::move(*trial);
          }
        reject(std::min(factor <= 0.25 ? 2 : 1, now.level - lowest));
      }
  }


  std::optional<StepTrial>
  AdaptiveSteps::attempt(DynamicalSystem &system, const State &state, const double size)
  {
    try
      {
        StepTrial trial = estimate->attempt(system, state, size, parameters.tolerance);
        n_solved += trial.n_solved;
        return trial;
      }
    catch (const StepError &error)
      {
        ++n_solved;
        if (now.level + static_cast<int>(times_halved) <= lowest)
          throw given_up(error, state.time, size);
        return {};
      }
  }


  void AdaptiveSteps::reject(const int levels)
  {
    ++n_rejected;
    now.rest = rules.rest;
    now.level -= levels;
  }


  double AdaptiveSteps::span(const State &state, const double touch) const
  {
    double       size  = std::ldexp(parameters.first, now.level);
    const double clear = clear_of_touch * std::min(size, parameters.first);
    const double left  = parameters.end_time - state.time;
    // No tiny last step: forces are changes of momentum divided by it.
    if (left <= (1.25 + round_off) * size)
      return left;
    if (left < 2. * size)
      size = left / 2.;
    // Round-off would decide whether a step that ends at the touch sees it. Not nearer, either: a
    // tiny part of an impact, seen by a whole step, says little about the rest of it.
    return std::abs(touch - size) < clear ? touch + clear : size;
  }


  StepReport
  AdaptiveSteps::hand_out_one_of_several(DynamicalSystem &system, State &state, TakenStep &&step)
  {
    if (MovingContact *contact = system.capabilities().moving_contact)
      contact->return_to(state, step.state); // it has the geometry of the last one
    return hand_out(state, std::move(step));
  }


  StepReport AdaptiveSteps::hand_out(State &state, TakenStep &&step)
  {
    estimate->accept(state, step.state);
    const double size = step.report.step_size;
    now.smallest_size = now.n_accepted == 0 ? size : std::min(now.smallest_size, size);
    now.largest_size  = std::max(now.largest_size, size);
    ++now.n_accepted;
    state = std::move(step.state);
    return step.report;
  }


  void AdaptiveSteps::take_back()
  {
    ++n_rejected;
    estimate->take_back();
    // Only what was too long is so on a finer mesh, too.
    const Memory later = now;
    now                = before;
    now.level          = std::min(later.level, before.level);
    now.rest           = std::max(later.rest, before.rest);
  }


  double AdaptiveSteps::fraction_done(const State &state) const
  {
    return state.time / parameters.end_time;
  }


  void AdaptiveSteps::forget()
  {
    waiting.reset();
    new_mesh = true;
  }


  void AdaptiveSteps::archive(Archive &archive)
  {
    archive(now, n_rejected, n_solved, has_said_inaccurate, inaccurate_since);
    estimate->archive(archive);
  }


  std::vector<std::string> AdaptiveSteps::news()
  {
    if (!std::exchange(says_inaccurate, false))
      return {};
    has_said_inaccurate = true;
    std::ostringstream text;
    text.precision(3);
    text << "since time " << inaccurate_since << " steps stay at the smallest size, "
         << std::ldexp(parameters.first, lowest) << ", with errors above `"
         << rules.key_of_tolerance << " = " << parameters.tolerance
         << "`, and cost what fixed steps of that size do. "
         << (parameters.tolerance < rules.enough_for_impacts
               ? "Impacts and friction seldom allow less than 0.1: give a larger tolerance"
               : "Give a larger tolerance or fixed steps")
         << ", or a smaller `Time/Minimum step size` if such errors are too large.";
    return {text.str()};
  }


  std::string AdaptiveSteps::summary() const
  {
    std::ostringstream text;
    text << "  steps             " << now.n_accepted << " accepted, sizes from "
         << now.smallest_size << " to " << now.largest_size << "; " << n_rejected
         << " attempts rejected; " << n_solved << " steps computed for that\n";
    if (now.n_inaccurate > 0)
      text << "                    of " << now.n_trials << " sizes that were tried and accepted "
           << now.n_inaccurate << " are the smallest one, with errors above the tolerance\n";
    return text.str();
  }
} // namespace signorini
