// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_contact_implicit_newmark_h
#define signorini_schemes_contact_implicit_newmark_h

#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  /**
   * Newmark scheme with fully implicit contact forces (@cite kane_repetto_ortiz_marsden_1999;
   * @cite krause_walloth_2012, Algorithm 5):
   * @f[
   *   (M + \tfrac{\tau^2}4 A) d = \tau M v - \tfrac{\tau^2}2 A u + \tfrac{\tau^2}2 r,
   *   \quad d \cdot \nu \le \mathrm{gap},
   *   \quad v_\text{new} = -v + \tfrac2\tau d.
   * @f]
   *
   * Second order without contact; the contact force is a midpoint quantity. Energy never grows,
   * @f[
   *   E_\text{new} - E = r \cdot d \le 0,
   * @f]
   * no penetration, but the normal velocity of nodes in contact alternates in sign, and the contact
   * force oscillates.
   */
  class ContactImplicitNewmark : public TimeScheme
  {
  public:
    explicit ContactImplicitNewmark(const TrapezoidalRule &rule = TrapezoidalRule())
      : rule(rule)
    {
    }

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

  private:
    const TrapezoidalRule rule;
  };
} // namespace signorini

#endif
