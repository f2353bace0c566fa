// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_contact_stabilized_newmark_h
#define signorini_schemes_contact_stabilized_newmark_h

#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  /**
   * Contact-stabilized Newmark scheme (@cite deuflhard_krause_ertel_2008;
   * @cite krause_walloth_2012, Algorithm 6). The predictor of the increment is projected onto the
   * admissible ones in @f$L^2@f$ before the forces act, equations (36) and (38) of the paper,
   * @f{align*}{
   *   p &= \operatorname{argmin} \{ \tfrac12 (p - \tau v)^T M (p - \tau v) :
   *                                 p \cdot \nu \le \mathrm{gap} \}, \\
   *   (M + \tfrac{\tau^2}4 A) d &= M p - \tfrac{\tau^2}2 A u + \tfrac{\tau^2}2 r,
   *     \quad d \cdot \nu \le \mathrm{gap}, \\
   *   v_\text{new} &= v + \tfrac2\tau (d - p).
   * @f}
   *
   * This takes the part of the contact force away that only stops the mass of the contact nodes,
   * and with it the oscillation. Second order without contact. Energy never grows (with the
   * consistent mass in the projection), equation (39) of the paper,
   * @f[
   *   E_\text{new} - E = r \cdot d + \tfrac2{\tau^2} (\tau v - p)^T M (d - p),
   *   \quad \text{both terms} \le 0.
   * @f]
   *
   * No penetration. The normal velocity of a node that stays in contact is frozen at its value
   * before the impact. The reaction of the projection is not part of the contact force.
   *
   * With friction this is Algorithm 7 of the paper, with the force of friction in (43) as well,
   * where the printed equation drops it; its work is a third term @f$\le 0@f$. A node that stops
   * slipping keeps a tangential velocity that changes its sign in every step: it has no tangential
   * predictor. `stop_sticking_nodes` takes it: the step ends with the velocity that is closest in
   * @f$M@f$ and zero along the tangents at nodes that touched before and stick. This projection can
   * only take energy (booked with friction).
   */
  class ContactStabilizedNewmark : public TimeScheme
  {
  public:
    explicit ContactStabilizedNewmark(const bool             stop_sticking_nodes = true,
                                      const TrapezoidalRule &rule = TrapezoidalRule())
      : stop_sticking_nodes(stop_sticking_nodes)
      , rule(rule)
    {
    }

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

    Needs needs() const override
    {
      Needs needs;
      needs.projections = true;
      return needs;
    }

  private:
    const bool            stop_sticking_nodes;
    const TrapezoidalRule rule;
  };
} // namespace signorini

#endif
