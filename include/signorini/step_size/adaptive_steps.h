// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_adaptive_steps_h
#define signorini_step_size_adaptive_steps_h

#include <signorini/step_size/time_stepping.h>

#include <functional>
#include <memory>
#include <optional>

namespace signorini
{
  /**
   * Steps whose size follows an estimate of their error. With the tolerance @f$\mathrm{TOL}@f$ and
   * an error @f$\varepsilon = O(\tau^{1/\kappa})@f$,
   * @f[
   *   \tau_\text{new} = \tau \min(2, \max(\tfrac14, (0.8\, \mathrm{TOL} / \varepsilon)^\kappa)),
   * @f]
   * accepted if @f$\varepsilon \le \mathrm{TOL}@f$ or @f$\tau@f$ is the smallest size.
   *
   * - Sizes are the first one times powers of two, so that a size comes back and with it its
   *   matrix. Of another size are the last two steps of a run, because the end time is met exactly,
   *   and a step to the touch, see below.
   * - Longer steps are tried only where the factor reaches 2, and not in the steps after a
   *   rejection; in flight already where the error is half of @f$\mathrm{TOL}@f$, because
   *   vibrations weaker than @f$\mathrm{TOL}@f$ need not be followed and their error does not grow
   *   with the step. An estimate may have other StepRules.
   * - In flight a step is at most about half as long as the time until the first node touches, but
   *   not shorter than the smallest size: the approach ends after some steps, and contact begins
   *   with a small one. Where flight is free, a step may come close to the touch, and contact
   *   begins with the first size, if that is not rejected.
   * - No step but the last one ends at the touch, where round-off would decide whether there is
   * contact. One that would end within an eighth of its size before or after it ends an eighth
   * after it; longer ones in free flight end an eighth of the first size before it, or earlier.
   * - A step that cannot be solved is rejected, too; for that alone sizes go below the smallest
   * one.
   * - Below the smallest size the shock on the mesh is what is wrong, and no step size helps.
   */
  class AdaptiveSteps : public TimeStepping
  {
  public:
    struct Parameters
    {
      double tolerance; ///< relative
      double first;     ///< size of the first step
      /**
       * Sizes are not below, but those of the halves of a doubled step and of the last two of the
       * run; 0: see StepRules::wave_part
       */
      double minimum;
      double maximum;
      double end_time;
      /**
       * The time that a wave takes through the smallest cell of the present mesh. Empty: there are
       * no cells.
       */
      std::function<double()> shortest_wave_time = {};
    };

    AdaptiveSteps(std::unique_ptr<StepEstimate> estimate, const Parameters &parameters);

    StepReport advance(DynamicalSystem &system, State &state) override;
    double     fraction_done(const State &state) const override;
    void       forget() override;
    void       archive(Archive &archive) override;
    void       take_back() override;
    /** Says once, with the time, that steps stay at the smallest size with too large errors. */
    std::vector<std::string> news() override;
    std::string              summary() const override;

    unsigned int rejected() const { return n_rejected; }
    unsigned int solved() const { return n_solved; }

  private:
    const std::unique_ptr<StepEstimate> estimate;
    const Parameters                    parameters;
    const StepRules                     rules;
    const int                           highest;         ///< sizes are first 2^level
    int                                 lowest   = 0;    ///< on this mesh
    bool                                new_mesh = true; ///< since the last step
    std::optional<TakenStep>
      waiting; ///< the second half of a doubled step, when the first one has been handed out
    unsigned int n_rejected = 0, n_solved = 0;

    /** What the step that was handed out last has changed. */
    struct Memory
    {
      int          level         = 0; ///< of the next step
      unsigned int rest          = 0; ///< steps that are not to be followed by a longer one
      unsigned int n_accepted    = 0;
      double       smallest_size = 0., largest_size = 0.; ///< accepted so far
      /** Accepted trials whose error was too large for them: in sequence until now, and in all. */
      unsigned int n_inaccurate_now = 0, n_inaccurate = 0, n_trials = 0;
    };
    Memory now, before; ///< the step that was handed out last
    bool   says_inaccurate = false, has_said_inaccurate = false;
    double inaccurate_since = 0.; ///< time at which the sequence began that is told of

    double    minimum() const;
    void      approach(double touch);
    void      count(const StepTrial &trial, const State &state);
    void      choose_next_size(const StepTrial &trial, double factor);
    StepTrial find_trial(DynamicalSystem &system, const State &state);
    StepTrial find_trial_or_forget_it(DynamicalSystem &system, const State &state);
    double    span(const State &state, double touch) const;
    /** @return nothing if the step cannot be solved */
    std::optional<StepTrial> attempt(DynamicalSystem &system, const State &state, double size);
    void                     reject(int levels);
    StepReport               hand_out(State &state, TakenStep &&step);
    /** The same, with the geometry that it was made with. */
    StepReport hand_out_one_of_several(DynamicalSystem &system, State &state, TakenStep &&step);
  };
} // namespace signorini

#endif
