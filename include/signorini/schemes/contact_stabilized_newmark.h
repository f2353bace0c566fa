// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_contact_stabilized_newmark_h
#define signorini_schemes_contact_stabilized_newmark_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Contact-stabilized Newmark scheme (Deuflhard, Krause and Ertel 2008; Krause and Walloth 2012, Algorithm 6). The predictor of the
   * increment is projected onto the admissible ones in L2 before the forces act,
   *
   *   p = argmin { 1/2 (p - tau v)'M(p - tau v) : p.nu <= gap },
   *   (M + tau^2/4 A) d = M p - tau^2/2 A u + tau^2/2 r,   d.nu <= gap,
   *   v_new = v + 2/tau (d - p).
   *
   * This takes the part of the contact force away that only stops the mass of the contact nodes, and with it the oscillation. Second
   * order without contact. Energy never grows (with the consistent mass in the projection),
   *
   *   E_new - E = r.d + 2/tau^2 (tau v - p)'M(d - p),   both terms <= 0.
   *
   * No penetration. The normal velocity of a node that stays in contact is frozen at its value before the impact. The reaction of
   * the projection is not part of the contact force.
   *
   * With friction this is Algorithm 7 of the paper, with the force of friction in (43) as well, where the printed equation drops it; its work is
   * a third term <= 0. A node that stops slipping keeps a tangential velocity that changes its sign in every step: it has no tangential
   * predictor. `stop_sticking_nodes` takes it: the step ends with the velocity that is closest in M and zero along the tangents at nodes that
   * touched before and stick. This projection can only take energy (booked with friction).
   */
  class ContactStabilizedNewmark : public TimeScheme
  {
  public:
    explicit ContactStabilizedNewmark(const bool stop_sticking_nodes = true)
      : stop_sticking_nodes(stop_sticking_nodes)
    {
    }

    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;

    Needs needs() const override { return {true, false, false}; }

  private:
    const bool stop_sticking_nodes;
  };
} // namespace signorini

#endif
