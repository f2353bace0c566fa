// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_distance_indicator_h
#define signorini_adaptivity_distance_indicator_h

#include <signorini/adaptivity/error_indicator.h>

namespace signorini
{
  /**
   * How close cells of contact surfaces are to the other side, at the end of the step or soon after
   * it, at constant velocity:
   *
   *   eta_T = Distance / (smallest gap of the nodes of T), at most 4,
   *
   * and zero for cells without contact nodes or their partners. No estimate of any error.
   */
  template <int dim>
  class DistanceIndicator : public ErrorIndicator<dim>
  {
  public:
    static constexpr double too_close  = 1.;  ///< from here on a cell is to be refined
    static constexpr double far_enough = 0.4; ///< below, it may be coarsened

    /**
     * @param first_step_size serves before the first step
     * @param least           what is less may be zero
     */
    DistanceIndicator(const Discretization<dim>  &discretization,
                      const ContactSurface<dim>  &surface,
                      const AdaptivityParameters &parameters,
                      double                      first_step_size,
                      double                      least = far_enough);

    dealii::Vector<double> evaluate(const StepRecord &step) const override;

  private:
    const Discretization<dim> &discretization;
    const ContactSurface<dim> &surface;
    const AdaptivityParameters parameters;
    const double               first_step_size, least;
  };
} // namespace signorini

#endif
