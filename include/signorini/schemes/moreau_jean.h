// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_moreau_jean_h
#define signorini_schemes_moreau_jean_h

#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  /**
   * Time stepping of Moreau and Jean with @f$\theta = \tfrac12@f$ and restitution 0
   * (@cite jean_1999): contact is a condition of velocities. Nodes that would penetrate in the
   * middle of the step, @f$\mathrm{gap} - \tfrac\tau2 v \cdot \nu \le 0@f$, may not approach at its
   * end,
   * @f{align*}{
   *   M (v_\text{new} - v) + \tau A (u + \tfrac12 d) &= P,
   *     \quad d = \tfrac\tau2 (v + v_\text{new}), \\
   *   v_\text{new} \cdot \nu &\le 0 \text{ where the prediction touches.}
   * @f}
   *
   * As a problem of increments this is
   * @f[
   *   (M + \tfrac{\tau^2}4 A) d = \tau M v - \tfrac{\tau^2}2 A u + \tfrac\tau2 P
   *   \quad \text{with} \quad d \cdot \nu \le \tfrac\tau2 v \cdot \nu.
   * @f]
   * Energy never grows while the bodies do not separate:
   * @f$E_\text{new} - E = \tfrac1\tau P \cdot d@f$. Penetration up to @f$\tau@f$ times the speed of
   * approach remains, as the position is never corrected. The state's contact force is
   * @f$P / \tau@f$.
   */
  class MoreauJean : public TimeScheme
  {
  public:
    explicit MoreauJean(const TrapezoidalRule &rule = TrapezoidalRule())
      : rule(rule)
    {
    }

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

  private:
    const TrapezoidalRule rule;
  };
} // namespace signorini

#endif
