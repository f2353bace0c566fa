// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_indicator.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  ResidualIndicator<dim>::ResidualIndicator(const Discretization<dim>      &discretization,
                                            const ContactSurface<dim>      &surface,
                                            const DirichletConditions<dim> &dirichlet,
                                            const TimeIntegration          &time)
    : discretization(discretization)
    , surface(surface)
    , time(time)
    , estimate(discretization, surface, dirichlet)
    , body_force(discretization)
  {
  }


  template <int dim>
  dealii::Vector<double> ResidualIndicator<dim>::evaluate(const StepRecord &step) const
  {
    if (step.step_size == 0.)
      return dealii::Vector<double>(discretization.mesh().triangulation().n_active_cells());
    dealii::Vector<double> result =
      estimate.squares(balance_of_step(discretization, surface, step, time, body_force),
                       ResidualWeights{step.step_size});
    for (double &value : result)
      value = std::sqrt(value);
    remove_round_off(step.end, result);
    return result;
  }


  template class ResidualIndicator<2>;
  template class ResidualIndicator<3>;
} // namespace signorini
