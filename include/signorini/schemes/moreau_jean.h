// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_moreau_jean_h
#define signorini_schemes_moreau_jean_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Time stepping of Moreau and Jean with theta = 1/2 and restitution 0 (Jean 1999): contact is a condition of velocities. Nodes that
   * would penetrate in the middle of the step, gap - tau/2 v.nu <= 0, may not approach at its end,
   *
   *   M (v_new - v) + tau A (u + d/2) = P,   d = tau (v + v_new)/2,   v_new.nu <= 0 where the prediction touches.
   *
   * As a problem of increments this is (M + tau^2/4 A) d = tau M v - tau^2/2 A u + tau/2 P with d.nu <= tau/2 v.nu. Energy never grows
   * while the bodies do not separate: E_new - E = 1/tau P.d. Penetration up to tau times the speed of approach remains, as the
   * position is never corrected. The state's contact force is P / tau.
   */
  class MoreauJean : public TimeScheme
  {
  public:
    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;
  };
} // namespace signorini

#endif
