// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_laursen_love_h
#define signorini_schemes_laursen_love_h

#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  /**
   * Contact-implicit Newmark scheme whose loss of energy is given back as an impulse at the contact
   * nodes (after @cite laursen_love_2002; @cite krause_walloth_2012, Algorithm 2):
   * @f{align*}{
   *   (M + \tfrac{\tau^2}4 A) d &= \tau M v - \tfrac{\tau^2}2 A u + \tfrac{\tau^2}2 r,
   *     \quad d \cdot \nu \le \mathrm{gap}, \\
   *   v_\text{new} &= v + \tfrac2\tau (d - \tau v) + \alpha M^{-1} j.
   * @f}
   *
   * The kinetic energy of the impulses,
   * @f$\alpha j \cdot v^* + \tfrac12 \alpha^2 j \cdot M^{-1} j@f$, shall be the work
   * @f$-r \cdot d \ge 0@f$ that contact has taken; the positive root exists always and pushes the
   * bodies apart. There are two ways to share the impulses among the nodes:
   *
   * - per node: @f$j@f$ solves the coupled equations (NodeImpulses), and @f$\alpha = 1@f$ but for
   *   what their solver leaves. A step whose equations cannot be solved takes the common way and
   *   says so in its report.
   * - common: @f$j = r@f$, impulses along the contact forces, one equation for @f$\alpha@f$ in
   *   place of the coupled ones of the single nodes. It couples contacts that have nothing to do
   *   with each other.
   *
   * Either way @f$E_\text{new} = E@f$ exactly, no penetration, linear momentum as without impulses.
   * The state's contact force is @f$r + \alpha j / \tau@f$: all that acted on average over the
   * step.
   */
  class LaursenLove : public TimeScheme
  {
  public:
    explicit LaursenLove(const bool             separate_nodes = true,
                         const TrapezoidalRule &rule           = TrapezoidalRule())
      : separate_nodes(separate_nodes)
      , rule(rule)
    {
    }

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

    Needs needs() const override
    {
      Needs needs;
      needs.impulses = separate_nodes;
      return needs;
    }

  private:
    const bool            separate_nodes;
    const TrapezoidalRule rule;
  };
} // namespace signorini

#endif
