// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_contact_implicit_newmark_h
#define signorini_schemes_contact_implicit_newmark_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Newmark scheme with fully implicit contact forces (Kane, Repetto, Ortiz and Marsden 1999; Krause and Walloth 2012, Algorithm 5),
   *
   *   (M + tau^2/4 A) d = tau M v - tau^2/2 A u + tau^2/2 r,   d.nu <= gap,   v_new = -v + 2/tau d.
   *
   * Second order without contact; the contact force is a midpoint quantity. Energy never grows,
   *
   *   E_new - E = r.d <= 0,
   *
   * no penetration, but the normal velocity of nodes in contact alternates in sign, and the contact force oscillates.
   */
  class ContactImplicitNewmark : public TimeScheme
  {
  public:
    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;
  };
} // namespace signorini

#endif
