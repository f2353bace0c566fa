// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_embedded_estimate_h
#define signorini_step_size_embedded_estimate_h

#include <signorini/step_size/step_estimate.h>

namespace signorini
{
  /**
   * One step, compared with what the last one predicted. With the mean acceleration @f$w@f$ of the
   * last step,
   * @f[
   *   v_\text{predicted} = v + \tau w \quad \text{or} \quad v_\text{predicted} = v,
   * @f]
   * whichever is closer to the new velocity in the norm of @f$M@f$. The second one is for the step
   * after a jolt, whose @f$w@f$ means nothing any more. The distance is @f$O(\tau^2)@f$ in smooth
   * motion and zero under constant acceleration. An estimate from above for schemes of order two,
   * relative to the largest motion so far, but it costs no solution and no product. In the first
   * step nothing is known.
   */
  class EmbeddedEstimate : public StepEstimate
  {
  public:
    explicit EmbeddedEstimate(TimeScheme &scheme)
      : scheme(scheme)
    {
    }

    StepTrial
    attempt(DynamicalSystem &system, const State &start, double span, double tolerance) override;
    void accept(const State &start, const State &end) override;
    void take_back() override { largest_energy = largest_energy_before; }

    /**
     * Errors in the energy norm are relative to this, the square root of the largest energy of the
     * motion so far.
     */
    double unit(const State &start, const State &end) const;

    void archive(Archive &archive) override { archive(largest_energy); }

  private:
    TimeScheme &scheme;
    double      largest_energy        = 0.; ///< of the motion so far
    double      largest_energy_before = 0.; ///< the step that was accepted last
  };
} // namespace signorini

#endif
