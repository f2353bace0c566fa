// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_energy_norm_h
#define signorini_step_size_energy_norm_h

#include <signorini/time/state.h>

namespace signorini
{
  /** 1/2 v'M v + 1/2 u'A u: kinetic and elastic energy. Collective. */
  double energy_of_motion(const State &state);

  /** The energy norm of a difference of motions, the square root of 1/2 dv'M dv + 1/2 du'A du. No product with M or A is needed. Collective. */
  double energy_distance(const State &a, const State &b);
} // namespace signorini

#endif
