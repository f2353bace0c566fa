// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_step_estimate_h
#define signorini_step_size_step_estimate_h

#include <signorini/base/archive.h>
#include <signorini/base/user_error.h>
#include <signorini/time/time_scheme.h>

namespace signorini
{
  /** How often a step that cannot be solved is halved before the run ends. */
  constexpr unsigned int times_halved = 5;

  /** What to throw when that did not help either. @param size the smallest that was tried */
  StepError given_up(const StepError &error, double time, double size);

  /**
   * Make a step from a state, which is not touched.
   * @throws StepError on all processes if it cannot be solved, or if its end has no finite energy
   */
  TakenStep
  take_step(TimeScheme &scheme, DynamicalSystem &system, const State &start, double step_size);

  /**
   * One or several steps that are to be accepted or rejected together, and the estimate of their
   * error.
   */
  struct StepTrial
  {
    std::vector<TakenStep> steps;
    ActiveSet              end_statuses; ///< of the contact nodes of this process
    double error = 0.; ///< estimate, relative to what the motion or its forces have been so far
    /** The step size goes with this power of the error: 1/p for an error O(tau^p). */
    double       exponent  = 1.;
    bool         is_known  = true;  ///< false: nothing to compare with, no error is known
    bool         is_flight = false; ///< no contact at start and end
    bool         is_free   = false; ///< a flight whose steps may have any length
    unsigned int n_solved  = 0;     ///< steps that were computed, those thrown away included
  };

  /** Write into each state of a trial what its step has changed, see LastStep. */
  void record_changes(const State &start, StepTrial &trial);

  /** What a kind of errors means for the choice of the next size. */
  struct StepRules
  {
    double content = 0.; ///< part of the tolerance below which a longer step is tried, anyway
    double content_in_flight = 0.5; ///< the same for steps without contact
    double worried           = 1.;  ///< part of the tolerance above which a shorter step follows
    /** Twice the size is tried wherever the power of the error allows it. */
    bool         trusts_power = true;
    unsigned int rest         = 8; ///< steps after a rejection that are not lengthened
    /** The default of the smallest size, of the time of a wave through the smallest cell. */
    double wave_part     = 0.5;
    double smallest_part = 0.; ///< of the first size: the default of the smallest size is not below
    /** No contact, no error: flight takes the longest steps that do not miss the touch. */
    bool flight_is_free = false;
    /** Tolerance with which impacts are followed: doc/step_size.md. */
    double      enough_for_impacts = 0.1;
    std::string key_of_tolerance   = "Time/Step tolerance"; ///< in the scene
  };

  /**
   * Makes steps of a scheme and estimates their error. Where contact begins, ends, or changes
   * between sticking and slipping the error of these schemes is @f$O(\tau^{1/2})@f$, elsewhere
   * @f$O(\tau^p)@f$ (@cite klapproth_schiela_deuflhard_2011); hence the exponent.
   */
  class StepEstimate
  {
  public:
    virtual ~StepEstimate() = default;

    /**
     * From a state over a span of time. The state is not touched.
     * @param tolerance relative errors below are as good as none
     */
    virtual StepTrial
    attempt(DynamicalSystem &system, const State &start, double span, double tolerance) = 0;

    /**
     * A step counts: what is kept for the next estimate follows it. Numbers only, no vectors: the
     * mesh may change.
     */
    virtual void accept(const State & /*start*/, const State & /*end*/) {}

    /** The step that was accepted last does not count. */
    virtual void take_back() {}

    /** The numbers that are kept. */
    virtual void archive(Archive & /*archive*/) {}

    virtual StepRules rules() const { return {}; }
  };
} // namespace signorini

#endif
