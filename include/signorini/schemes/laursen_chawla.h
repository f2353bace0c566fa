// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_laursen_chawla_h
#define signorini_schemes_laursen_chawla_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Newmark scheme with a discrete persistency condition (Laursen and Chawla 1997; Krause and Walloth 2012, Algorithm 1). Nodes that touch or
   * penetrate at the beginning of a step may not come any closer, the others are free to pass,
   *
   *   (M + tau^2/4 A) d = tau M v - tau^2/2 A u + tau^2/2 r,   d.nu <= 0 where gap <= 0,
   *   v_new = v + 2/tau (d - tau v).
   *
   * Contact forces act only where d.nu = 0 and do no work: E_new = E exactly. The price is penetration, up to tau times the
   * speed of approach, which is kept while the node is in contact. Second order without contact. The normal velocity of a node
   * in contact changes its sign in every step.
   */
  class LaursenChawla : public TimeScheme
  {
  public:
    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;
  };
} // namespace signorini

#endif
