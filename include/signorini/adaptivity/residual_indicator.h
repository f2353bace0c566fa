// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_residual_indicator_h
#define signorini_adaptivity_residual_indicator_h

#include <signorini/adaptivity/residual_estimate.h>

namespace signorini
{
  /**
   * The estimate of ResidualEstimate. With the goal `energy` by the weights of the step: the error
   * that a step adds in the energy norm of velocity and displacement, because its problem is solved
   * on this mesh. With the goal `contact force` by the weights at rest: the error of the
   * displacement for the forces of the step, those of inertia among them (see ForceError). Zero
   * before the first step, whose forces are not known, unless it is an equilibrium and the goal a
   * force.
   */
  template <int dim>
  class ResidualIndicator : public ErrorIndicator<dim>
  {
  public:
    ResidualIndicator(const Discretization<dim>      &discretization,
                      const ContactSurface<dim>      &surface,
                      const DirichletConditions<dim> &dirichlet,
                      const TimeIntegration          &time,
                      GoalKind                        goal = GoalKind::energy);

    dealii::Vector<double> evaluate(const StepRecord &step) const override;

  private:
    const Discretization<dim>  &discretization;
    const ContactSurface<dim>  &surface;
    const TimeIntegration       time;
    const GoalKind              goal;
    const ResidualEstimate<dim> estimate;
    mutable BodyForce<dim>      body_force; ///< keeps what it has evaluated
  };
} // namespace signorini

#endif
