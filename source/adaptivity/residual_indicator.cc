// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_indicator.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * How often pressure times gap counts for goals. It is an energy itself, where the other parts
     * are bounds from above, many times too large (ForceError::effectivity()); and of a contact of
     * one node it is all that tells how far from the true one its force is. Measured on such
     * meshes, see doc/adaptivity.md.
     */
    constexpr double gap_for_goals = 12.;
  } // namespace


  template <int dim>
  ResidualIndicator<dim>::ResidualIndicator(const Discretization<dim>      &discretization,
                                            const ContactSurface<dim>      &surface,
                                            const DirichletConditions<dim> &dirichlet,
                                            const TimeIntegration          &time,
                                            const GoalKind                  goal)
    : discretization(discretization)
    , surface(surface)
    , time(time)
    , goal(goal)
    , estimate(discretization, surface, dirichlet)
    , body_force(discretization)
  {
  }


  template <int dim>
  dealii::Vector<double> ResidualIndicator<dim>::evaluate(const StepRecord &step) const
  {
    const bool is_start = step.step_size == 0., is_weighed = goal == GoalKind::energy;
    if (is_start && (is_weighed || !time.starts_at_rest))
      return dealii::Vector<double>(discretization.mesh().triangulation().n_active_cells());
    dealii::Vector<double> result = estimate.squares(
      is_start ? balance_at_rest(
        discretization, surface, step.end.displacement, step.end.contact_force, step.end.time)
               : balance_of_step(discretization, surface, step, time, body_force),
      is_weighed ? ResidualWeights{step.step_size} : ResidualWeights{0., gap_for_goals});
    for (double &value : result)
      value = std::sqrt(value);
    remove_round_off(step.end, result);
    return result;
  }


  template class ResidualIndicator<2>;
  template class ResidualIndicator<3>;
} // namespace signorini
