// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_fixed_steps_h
#define signorini_step_size_fixed_steps_h

#include <signorini/step_size/time_stepping.h>

#include <cstdint>

namespace signorini
{
  /**
   * Steps of equal size. One that cannot be solved is made in parts: halves, or quarters, or what
   * it takes, down to the smallest part. After each part the longest one is tried that fits: to the
   * next half, or to the end of the step, so that the times of the whole steps are met again.
   *
   * Where a step begins is seen from the time of its state; nothing else is remembered.
   */
  class FixedSteps : public TimeStepping
  {
  public:
    FixedSteps(TimeScheme &scheme, const double step_size, const unsigned int n_steps)
      : scheme(scheme)
      , step_size(step_size)
      , n_steps(n_steps)
    {
    }

    StepReport advance(DynamicalSystem &system, State &state) override;
    double     fraction_done(const State &state) const override;

  private:
    static constexpr std::int64_t smallest_parts = std::int64_t(1) << times_halved; ///< of a step

    TimeScheme        &scheme;
    const double       step_size;
    const unsigned int n_steps;

    /** The time of a state in smallest parts. */
    std::int64_t parts_done(const State &state) const;
  };
} // namespace signorini

#endif
