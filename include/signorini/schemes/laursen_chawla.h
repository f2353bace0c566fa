// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_laursen_chawla_h
#define signorini_schemes_laursen_chawla_h

#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  /**
   * Newmark scheme with a discrete persistency condition (@cite laursen_chawla_1997;
   * @cite krause_walloth_2012, Algorithm 1). Nodes that touch or penetrate at the beginning of a
   * step may not come any closer, the others are free to pass,
   * @f{align*}{
   *   (M + \tfrac{\tau^2}4 A) d &= \tau M v - \tfrac{\tau^2}2 A u + \tfrac{\tau^2}2 r,
   *     \quad d \cdot \nu \le 0 \text{ where gap} \le 0, \\
   *   v_\text{new} &= v + \tfrac2\tau (d - \tau v).
   * @f}
   *
   * Contact forces act only where @f$d \cdot \nu = 0@f$ and do no work: @f$E_\text{new} = E@f$
   * exactly. The price is penetration, up to @f$\tau@f$ times the speed of approach, which is kept
   * while the node is in contact. Second order without contact. The normal velocity of a node in
   * contact changes its sign in every step.
   */
  class LaursenChawla : public TimeScheme
  {
  public:
    explicit LaursenChawla(const TrapezoidalRule &rule = TrapezoidalRule())
      : rule(rule)
    {
    }

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

  private:
    const TrapezoidalRule rule;
  };
} // namespace signorini

#endif
