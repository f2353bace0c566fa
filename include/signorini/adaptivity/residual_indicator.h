// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_residual_indicator_h
#define signorini_adaptivity_residual_indicator_h

#include <signorini/adaptivity/residual_estimate.h>

namespace signorini
{
  /**
   * The estimate of ResidualEstimate with the weights of the step: the error that a step adds in
   * the energy norm of velocity and displacement, because its problem is solved on this mesh. Zero
   * before the first step, whose forces are not known.
   */
  template <int dim>
  class ResidualIndicator : public ErrorIndicator<dim>
  {
  public:
    ResidualIndicator(const Discretization<dim>      &discretization,
                      const ContactSurface<dim>      &surface,
                      const DirichletConditions<dim> &dirichlet,
                      const TimeIntegration          &time);

    dealii::Vector<double> evaluate(const StepRecord &step) const override;

  private:
    const Discretization<dim>  &discretization;
    const ContactSurface<dim>  &surface;
    const TimeIntegration       time;
    const ResidualEstimate<dim> estimate;
    mutable BodyForce<dim>      body_force; ///< keeps what it has evaluated
  };
} // namespace signorini

#endif
