// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_khenous_laborde_renard_h
#define signorini_schemes_khenous_laborde_renard_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Newmark scheme for contact nodes without mass (Khenous, Laborde and Renard 2008; Krause and Walloth 2012, Algorithm 3). With the
   * redistributed mass M~ the motion between status changes is an ordinary differential equation with Lipschitz continuous contact forces,
   *
   *   (M~ + beta tau^2 A) d = M~ [tau v + tau^2 (1/2 - beta) a] + beta tau^2 (f_new - A u + r),   d.nu <= gap,
   *   a_new = [d - tau v - tau^2 (1/2 - beta) a] / (beta tau^2),   v_new = v + tau [(1 - gamma) a + gamma a_new],
   *
   * in equilibrium at the end of the step; massless nodes have no acceleration, and as velocity d/tau, which acts on nothing. No penetration, smooth
   * forces, second order for gamma = 1/2. With Q = 2 beta - gamma the energy of M~ obeys
   *
   *   E_new - E + Q tau^2/4 (a_new.M~ a_new - a.M~ a) = [(1 - gamma) r_n + gamma r].d - (gamma - 1/2) [d.A d + Q tau^2/2 Da.M~ Da],
   *
   * of no definite sign, but small, because r is continuous. The paper prints beta = gamma = 1/2, which keeps the energy plus
   * tau^2/8 a.M~ a; beta = 1/4, gamma = 1/2 keeps the energy itself where nothing touches. With beta = 1/2, gamma = 1 high frequencies are damped.
   */
  class KhenousLabordeRenard : public TimeScheme
  {
  public:
    KhenousLabordeRenard(double beta, double gamma);

    StepReport advance(DynamicalSystem &system, State &state, double step_size) override;

  private:
    const double beta, gamma;
  };
} // namespace signorini

#endif
