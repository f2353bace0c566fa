// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_backward_euler_h
#define signorini_schemes_backward_euler_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Backward Euler: everything acts at the end of the step,
   *
   *   (M + tau^2 A) d = tau M v - tau^2 A u + tau^2 (f_new + r),   d.nu <= gap,   v_new = d/tau.
   *
   * Order one, no penetration, no oscillation, nodes in contact have no velocity along the normal; the price is damping of all that
   * moves. With g the change of the load over the step and e = v_new - v,
   *
   *   E_new - E = r.d - 1/2 e'M e - 1/2 d'A d + 1/2 g.d   (work of the mean load apart),
   *
   * of which the last three are booked as change by the rule of integration. Here as the lower end of any comparison.
   */
  class BackwardEuler : public TimeScheme
  {
  public:
    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;
  };
} // namespace signorini

#endif
