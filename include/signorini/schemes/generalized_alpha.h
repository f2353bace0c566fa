// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_generalized_alpha_h
#define signorini_schemes_generalized_alpha_h

#include <signorini/schemes/alpha_rule.h>

namespace signorini
{
  /**
   * Generalized-alpha method (@cite chung_hulbert_1993) with one contact force per step; HHT-alpha
   * (@cite hilber_hughes_taylor_1977) is the case @f$\alpha_m = 0@f$. With accelerations @f$a@f$,
   * @f[
   *   M [(1 - \alpha_m) a_\text{new} + \alpha_m a] + A [(1 - \alpha_f) u_\text{new} + \alpha_f u]
   *     = (1 - \alpha_f) f_\text{new} + \alpha_f f + r,
   * @f]
   * see AlphaRule for the rest. The force @f$r@f$ acts against the elastic forces of
   * @f$t_\text{new} - \alpha_f \tau@f$, and it is that instant's. Second order, and damping of high
   * frequencies by choice. A baseline that users know: with contact there is no bound of the
   * energy, and the release of a loaded node can add some. The first acceleration is that of loads
   * and elastic forces.
   */
  class GeneralizedAlpha : public TimeScheme
  {
  public:
    explicit GeneralizedAlpha(const AlphaRule &rule)
      : rule(rule)
    {
    }

    /** HHT, -1/3 <= alpha <= 0. */
    static GeneralizedAlpha hht(double alpha) { return GeneralizedAlpha(AlphaRule(0., -alpha)); }

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

  private:
    const AlphaRule rule;
  };
} // namespace signorini

#endif
