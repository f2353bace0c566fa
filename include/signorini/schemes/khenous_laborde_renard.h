// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_khenous_laborde_renard_h
#define signorini_schemes_khenous_laborde_renard_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Newmark scheme for contact nodes without mass (@cite khenous_laborde_renard_2008;
   * @cite krause_walloth_2012, Algorithm 3). With the redistributed mass @f$\tilde M@f$ the motion
   * between status changes is an ordinary differential equation with Lipschitz continuous contact
   * forces,
   * @f{align*}{
   *   (\tilde M + \beta \tau^2 A) d
   *     &= \tilde M [\tau v + \tau^2 (\tfrac12 - \beta) a] + \beta \tau^2 (f_\text{new} - A u + r),
   *     \quad d \cdot \nu \le \mathrm{gap}, \\
   *   a_\text{new} &= [d - \tau v - \tau^2 (\tfrac12 - \beta) a] / (\beta \tau^2), \\
   *   v_\text{new} &= v + \tau [(1 - \gamma) a + \gamma a_\text{new}],
   * @f}
   * in equilibrium at the end of the step; massless nodes have no acceleration, and as velocity
   * @f$d / \tau@f$, which acts on nothing. No penetration, smooth forces, second order for
   * @f$\gamma = \tfrac12@f$. With @f$Q = 2 \beta - \gamma@f$ and @f$\Delta a = a_\text{new} - a@f$
   * the energy of @f$\tilde M@f$ obeys
   * @f{align*}{
   *   E_\text{new} - E
   *     + \tfrac{Q \tau^2}4 (a_\text{new} \cdot \tilde M a_\text{new} - a \cdot \tilde M a)
   *     &= [(1 - \gamma) r_n + \gamma r] \cdot d \\
   *     &- (\gamma - \tfrac12)
   *        [d \cdot A d + \tfrac{Q \tau^2}2 \Delta a \cdot \tilde M \Delta a],
   * @f}
   * of no definite sign, but small, because @f$r@f$ is continuous. The paper prints
   * @f$\beta = \gamma = \tfrac12@f$ in (30), which keeps the energy plus
   * @f$\tfrac{\tau^2}8 a \cdot \tilde M a@f$; @f$\beta = \tfrac14@f$, @f$\gamma = \tfrac12@f$ keeps
   * the energy itself where nothing touches. With @f$\beta = \tfrac12@f$, @f$\gamma = 1@f$ high
   * frequencies are damped.
   */
  class KhenousLabordeRenard : public TimeScheme
  {
  public:
    KhenousLabordeRenard(double beta, double gamma);

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

  private:
    const double beta, gamma;
  };
} // namespace signorini

#endif
