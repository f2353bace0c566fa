// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_energy_norm_h
#define signorini_step_size_energy_norm_h

#include <signorini/time/state.h>

namespace signorini
{
  /**
   * @f$\tfrac12 v^T M v + \tfrac12 u^T A u@f$: kinetic and elastic energy. Collective.
   */
  double energy_of_motion(const State &state);

  /**
   * The energy norm of a difference of motions,
   * @f$(\tfrac12 \delta v^T M \delta v + \tfrac12 \delta u^T A \delta u)^{1/2}@f$. No product with
   * @f$M@f$ or @f$A@f$ is needed. Collective.
   */
  double energy_distance(const State &a, const State &b);
} // namespace signorini

#endif
