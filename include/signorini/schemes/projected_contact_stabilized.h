// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_projected_contact_stabilized_h
#define signorini_schemes_projected_contact_stabilized_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Contact-stabilized Newmark scheme that keeps the projected velocity: what the projection of the predictor takes from the increment, it takes
   * from the velocity, too. (Not in Krause and Walloth 2012; close in spirit to the improved ContacX of Klapproth, Deuflhard and
   * Schiela 2010.)
   *
   *   p = argmin { 1/2 (p - tau v)'M(p - tau v) : p.nu <= gap },
   *   (M + tau^2/4 A) d = M p - tau^2/2 A u + tau^2/2 r,   d.nu <= gap,
   *   w = p/tau + 2/tau (d - p),
   *   v_new = argmin { 1/2 (v - w)'M(v - w) : v.nu = 0 where a node touched before and is held at the end }.
   *
   * With c = p - tau v and s = v_new - w the energy never grows,
   *
   *   E_new - E = r.d + 1/tau^2 c'M p - 1/(2 tau^2) c'M c - 1/2 s'M s,   all terms <= 0,
   *
   * and a node that stays in contact has no normal velocity: persistency, which no scheme of the paper combines with the sign of the
   * energy. No penetration. In one dimension s = 0. With more contact nodes the mass couples them: stopping one pulls p of its neighbours below
   * their gap, and w would be -p.nu/tau there. Both projections act as impulses; the state's contact force
   * r + M c / tau^2 + M s / tau contains them.
   */
  class ProjectedContactStabilized : public TimeScheme
  {
  public:
    explicit ProjectedContactStabilized(const bool stop_sticking_nodes = true)
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
