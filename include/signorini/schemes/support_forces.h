// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_support_forces_h
#define signorini_schemes_support_forces_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Book forces of the supports, which prescribe displacements, in the report of a step. They
   * stand beside loads and contact forces in the balance of the scheme:
   *
   * - where contact gives impulses or acts all through the step (all schemes but those below), the
   *   impulse of the step over its length, so that the momentum of the mass of the scheme changes
   *   by the step size times (load + contact + support), with the load of the scheme, the mean of
   *   both ends or (backward-euler) that of the end;
   * - `newmark`: the same, while its contact force is that of the end and acts with the mean of
   *   both ends;
   * - `generalized-alpha`, `nonsmooth-generalized-alpha`: the force in the balance of
   *   @f$(1 - \alpha_m) M a_{n+1} + \alpha_m M a_n@f$, plus the impulse of the jump over the
   *   step size;
   * - `khenous-laborde-renard`, `reference`: the force at the end, that of @f$M a_{n+1}@f$;
   * - `static`: the force at the end.
   *
   * @param factor   forces per reaction
   * @param reaction in the prescribed entries; nothing is booked in a system that has none
   */
  inline void add_support_force(DynamicalSystem &system,
                                const double     factor,
                                const Vector    &reaction,
                                StepReport      &report)
  {
    if (system.capabilities().moving_dirichlet == nullptr)
      return;
    if (report.support_force.size() == 0)
      report.support_force.reinit(reaction);
    report.support_force.add(factor, reaction);
  }
} // namespace signorini

#endif
