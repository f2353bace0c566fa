// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_projected_contact_stabilized_h
#define signorini_schemes_projected_contact_stabilized_h

#include <signorini/schemes/projected_predictor.h>
#include <signorini/schemes/trapezoidal_rule.h>

namespace signorini
{
  /**
   * Contact-stabilized Newmark scheme that keeps the projected velocity: what the projection of the
   * predictor takes from the increment, it takes from the velocity, too. (Not in
   * @cite krause_walloth_2012; close in spirit to the improved ContacX of
   * @cite klapproth_deuflhard_schiela_2010.)
   * @f{align*}{
   *   p &= \operatorname{argmin} \{ \tfrac12 (p - \tau v)^T M (p - \tau v) :
   *                                 p \cdot \nu \le \mathrm{gap} \}, \\
   *   (M + \tfrac{\tau^2}4 A) d &= M p - \tfrac{\tau^2}2 A u + \tfrac{\tau^2}2 r,
   *     \quad d \cdot \nu \le \mathrm{gap}, \\
   *   w &= \tfrac1\tau p + \tfrac2\tau (d - p), \\
   *   v_\text{new} &= \operatorname{argmin} \{ \tfrac12 (v - w)^T M (v - w) : v \cdot \nu = 0
   *     \text{ where a node touched before and is held at the end} \}.
   * @f}
   *
   * With @f$c = p - \tau v@f$ and @f$s = v_\text{new} - w@f$ the energy never grows,
   * @f[
   *   E_\text{new} - E = r \cdot d + \tfrac1{\tau^2} c^T M p - \tfrac1{2 \tau^2} c^T M c
   *                      - \tfrac12 s^T M s,
   *   \quad \text{all terms} \le 0,
   * @f]
   * and a node that stays in contact has no normal velocity: persistency, which no scheme of the
   * paper combines with the sign of the energy. No penetration. In one dimension @f$s = 0@f$. With
   * more contact nodes the mass couples them: stopping one pulls @f$p@f$ of its neighbours below
   * their gap, and @f$w@f$ would be @f$-\tfrac1\tau p \cdot \nu@f$ there. Both projections act as
   * impulses; the state's contact force @f$r + M c / \tau^2 + M s / \tau@f$ contains them.
   *
   * Where contact follows the motion and @f$\nu@f$ turns from @f$\nu_0@f$ at the start to
   * @f$\nu_1@f$ at the end, a node that touches has @f$p \cdot \nu \le \mathrm{gap} +
   * \tau \max(0, v \cdot (\nu - \nu_0))@f$, which stops what approaches and not what goes along
   * (MovingContact::tangential_approach()), and @f$v \cdot \nu_1 = 0@f$. Zero is admissible as
   * ever.
   *
   * Where @f$d@f$ leaves a node open by more than it moves, @f$p@f$ was stopped in vain: it
   * followed a velocity that alternates, and its reaction would be a force across a gap. The step
   * is made again with a projection that does not look at this node; the law of energy holds for
   * projections onto any set that contains @f$d@f$.
   */
  class ProjectedContactStabilized : public TimeScheme
  {
  public:
    explicit ProjectedContactStabilized(const bool             stop_sticking_nodes = true,
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

    /** Predictor and increment of a step. */
    struct Motion
    {
      ProjectedPredictor predictor;
      IncrementSolution  solution;
    };
    Motion
    move(DynamicalSystem &system, const State &state, double step_size, const NormalGap &gap);

    /** Per contact node whether the latest step has lifted its bound; for its repetitions. */
    std::vector<bool> lifted;
  };
} // namespace signorini

#endif
