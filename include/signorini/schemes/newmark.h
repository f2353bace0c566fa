// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_newmark_h
#define signorini_schemes_newmark_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Classical Newmark scheme, 2 beta = gamma = 1/2 (Krause and Walloth 2012, equations (19) and (20)): the contact forces of both ends of
   * the step act with equal weights, like the elastic ones,
   *
   *   (M + tau^2/4 A) d = tau M v - tau^2/2 A u + tau^2/4 (r_n + r),   d.nu <= gap,   v_new = -v + 2/tau d.
   *
   * Second order without contact. At impact the contact force oscillates and the energy may grow without bound,
   *
   *   E_new - E = 1/2 (r_n + r).d,
   *
   * positive whenever a loaded node opens. No penetration. It is here to be compared with.
   */
  class Newmark : public TimeScheme
  {
  public:
    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;
  };
} // namespace signorini

#endif
