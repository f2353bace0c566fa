// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/kelly_indicator.h>
#include <signorini/adaptivity/residual_parts.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  KellyIndicator<dim>::KellyIndicator(const Discretization<dim> &discretization)
    : mesh(discretization)
  {
  }


  template <int dim>
  dealii::Vector<double> KellyIndicator<dim>::evaluate(const StepRecord &step) const
  {
    dealii::Vector<double> result(mesh.discretization.mesh().triangulation().n_active_cells());
    const Vector           u = mesh.interpolate_hanging_nodes(step.end.displacement);
    add_stress_jumps(StressVectors<dim>(mesh, u), ResidualWeights(), result);
    for (double &value : result)
      value = std::sqrt(value / 24.);
    remove_round_off(step.end, result);
    return result;
  }


  template class KellyIndicator<2>;
  template class KellyIndicator<3>;
} // namespace signorini
