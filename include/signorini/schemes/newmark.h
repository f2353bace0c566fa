// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_newmark_h
#define signorini_schemes_newmark_h

#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  /**
   * Classical Newmark scheme, @f$2 \beta = \gamma = \tfrac12@f$ (@cite krause_walloth_2012,
   * equations (19) and (20)). The contact forces of both ends of the step act with equal weights,
   * like the elastic ones,
   * @f[
   *   (M + \tfrac{\tau^2}4 A) d = \tau M v - \tfrac{\tau^2}2 A u + \tfrac{\tau^2}4 (r_n + r),
   *   \quad d \cdot \nu \le \mathrm{gap},
   *   \quad v_\text{new} = -v + \tfrac2\tau d.
   * @f]
   *
   * Second order without contact. At impact the contact force oscillates and the energy may grow
   * without bound,
   * @f[
   *   E_\text{new} - E = \tfrac12 (r_n + r) \cdot d,
   * @f]
   * positive whenever a loaded node opens. No penetration. It is here to be compared with.
   */
  class Newmark : public TimeScheme
  {
  public:
    explicit Newmark(const TrapezoidalRule &rule = TrapezoidalRule())
      : rule(rule)
    {
    }

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

  private:
    const TrapezoidalRule rule;
  };
} // namespace signorini

#endif
