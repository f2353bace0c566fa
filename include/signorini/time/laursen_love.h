// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_laursen_love_h
#define signorini_time_laursen_love_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Contact-implicit Newmark scheme whose loss of energy is given back as an impulse at the contact nodes (after Laursen and Love 2002; Krause
   * and Walloth 2012, Algorithm 2),
   *
   *   (M + tau^2/4 A) d = tau M v - tau^2/2 A u + tau^2/2 r,   d.nu <= gap,
   *   v_new = v + 2/tau (d - tau v) + alpha M^-1 r.
   *
   * The impulses alpha r along the contact forces replace the coupled equations of the single nodes by one equation for alpha: their kinetic
   * energy alpha r.v* + 1/2 alpha^2 r.M^-1 r shall be the work -r.d >= 0 that contact has taken. Its positive root exists always and pushes the
   * bodies apart. E_new = E exactly, no penetration, linear momentum as without impulses. The state's contact
   * force is r + alpha r / tau: all that acted on average over the step.
   */
  class LaursenLove : public TimeScheme
  {
  public:
    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;
  };
} // namespace signorini

#endif
