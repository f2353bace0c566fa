// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_reference_integration_h
#define signorini_schemes_reference_integration_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * Not a scheme but the solution that schemes approximate. With a redistributed mass the problem
   * in space is an ordinary differential equation with Lipschitz continuous right-hand side
   * (@cite khenous_laborde_renard_2008),
   * @f{align*}{
   *   \dot u &= v, \\
   *   \tilde M \dot v &= f - A u + r
   *     \quad \text{in nodes with mass } (r \text{: of the other body}),
   * @f}
   * contact nodes in static equilibrium with @f$u \cdot \nu \le g@f$, and SUNDIALS ARKODE
   * integrates it with explicit Runge-Kutta formulas of order 5 and error control, as many steps of
   * its own as it takes within each step of the run. Against it, the error of a scheme in time can
   * be measured on the same mesh. What the tolerance leaves is seen as unexplained energy. Slow:
   * every stage solves a contact problem. Prescribed displacements have to be constant.
   */
  class ReferenceIntegration : public TimeScheme
  {
  public:
    /** @param tolerance accepted relative error per step of the integrator */
    explicit ReferenceIntegration(double tolerance);

    TakenStep make_step(DynamicalSystem &system, const State &start, double step_size) override;

    Needs needs() const override
    {
      Needs needs;
      needs.massless_nodes = true;
      return needs;
    }

  private:
    const double tolerance;
  };
} // namespace signorini

#endif
