// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/contact_implicit_newmark.h>

namespace signorini
{
  TakenStep
  ContactImplicitNewmark::make_step(DynamicalSystem &system, const State &start, const double tau)
  {
    // (33): (M + tau^2/4 A) d = tau M v - tau^2/2 A u + tau^2/2 r
    const Vector            b        = rule.right_hand_side(system, start, tau);
    const NormalGap         gap      = system.normal_gap(start.displacement);
    const IncrementSolution solution = rule.solve(system, start, tau, b, gap);
    // (34): v_new - v = 2/tau (d - tau v)
    return rule.finish_implicit(system, start, tau, solution);
  }
} // namespace signorini
