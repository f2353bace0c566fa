// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_backward_euler_h
#define signorini_schemes_backward_euler_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Backward Euler. Everything acts at the end of the step,
   * @f[
   *   (M + \tau^2 A) d = \tau M v - \tau^2 A u + \tau^2 (f_\text{new} + r),
   *   \quad d \cdot \nu \le \mathrm{gap},
   *   \quad v_\text{new} = d / \tau.
   * @f]
   *
   * Order one, no penetration, no oscillation, nodes in contact have no velocity along the normal;
   * the price is damping of all that moves. With @f$g@f$ the change of the load over the step and
   * @f$e = v_\text{new} - v@f$,
   * @f[
   *   E_\text{new} - E = r \cdot d - \tfrac12 e^T M e - \tfrac12 d^T A d + \tfrac12 g \cdot d
   *   \quad \text{(work of the mean load apart)},
   * @f]
   * of which the last three are booked as change by the rule of integration. Here as the lower end
   * of any comparison.
   */
  class BackwardEuler : public TimeScheme
  {
  public:
    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;
  };
} // namespace signorini

#endif
