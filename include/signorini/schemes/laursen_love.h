// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_laursen_love_h
#define signorini_schemes_laursen_love_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Contact-implicit Newmark scheme whose loss of energy is given back as an impulse at the contact nodes (after Laursen and Love 2002; Krause
   * and Walloth 2012, Algorithm 2),
   *
   *   (M + tau^2/4 A) d = tau M v - tau^2/2 A u + tau^2/2 r,   d.nu <= gap,
   *   v_new = v + 2/tau (d - tau v) + alpha M^-1 j.
   *
   * The kinetic energy of the impulses, alpha j.v* + 1/2 alpha^2 j.M^-1 j, shall be the work -r.d >= 0 that contact has taken; the positive
   * root exists always and pushes the bodies apart. There are two ways to share the impulses among the nodes:
   *
   * - common: j = r, impulses along the contact forces, one equation for alpha in place of the coupled ones of the single nodes;
   * - per node: j solves the coupled equations (NodeImpulses), and alpha = 1 but for what their solver leaves. A step
   *   whose equations cannot be solved takes the common way and says so in its report.
   *
   * Either way E_new = E exactly, no penetration, linear momentum as without impulses. The state's contact
   * force is r + alpha j / tau: all that acted on average over the step.
   */
  class LaursenLove : public TimeScheme
  {
  public:
    explicit LaursenLove(const bool separate_nodes = false)
      : separate_nodes(separate_nodes)
    {
    }

    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;

    Needs needs() const override { return {false, separate_nodes, false}; }

  private:
    const bool separate_nodes;
  };
} // namespace signorini

#endif
