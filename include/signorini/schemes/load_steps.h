// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_load_steps_h
#define signorini_schemes_load_steps_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * From equilibrium to equilibrium, without inertia: time is a parameter of loads and conditions,
   * and a step ends in the static solution under those of its end,
   * @f[
   *   A (u + d) = f_\text{new} + r + s, \quad d \cdot \nu \le \mathrm{gap}, \quad v = 0,
   * @f]
   * with the normal contact forces and friction @f$r = n + t@f$ and the forces s of what prescribes
   * displacements. Friction is incremental: slip is that of the step.
   *
   * The elastic energy changes by @f$\tfrac12 (A u + A u_\text{new}) \cdot d@f$, and therefore the
   * works of loads, normal forces and supports are those of the means of their values at both ends
   * (the trapezoidal rule), exactly. Friction takes @f$t \cdot d \le 0@f$, by its law at the end.
   * Booked as work of the scheme is what these leave,
   * @f[
   *   \tfrac12 (t_\text{old} - t) \cdot d + \tfrac12 e \cdot d - \tfrac12 v^T M v,
   * @f]
   * with what was not balanced at the start, @f$e = A u - f - r_\text{old} - s@f$: in a run the
   * loads of time 0 if it does not start in equilibrium, and what a new mesh has brought out of
   * balance. The velocity v of the start is zero in a run.
   */
  class LoadSteps : public TimeScheme
  {
  public:
    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

    Needs needs() const override
    {
      Needs needs;
      needs.statics = true;
      return needs;
    }
  };
} // namespace signorini

#endif
