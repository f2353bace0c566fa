// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_estimate.h>

namespace signorini
{
  template <int dim>
  ResidualEstimate<dim>::ResidualEstimate(const Discretization<dim>      &discretization,
                                          const ContactSurface<dim>      &surface,
                                          const DirichletConditions<dim> &dirichlet)
    : surface(surface)
    , dirichlet(dirichlet)
    , mesh(discretization)
    , roles(mesh, surface)
  {
  }


  template <int dim>
  dealii::Vector<double> ResidualEstimate<dim>::squares(const ForceBalance    &balance,
                                                        const ResidualWeights &weights) const
  {
    dealii::Vector<double>   result(mesh.discretization.mesh().triangulation().n_active_cells());
    const Vector             u = mesh.interpolate_hanging_nodes(balance.displacement);
    const StressVectors<dim> stress(mesh, u);
    add_interior_residual(
      stress, mesh.interpolate_hanging_nodes(balance.specific_force), weights, result);
    add_stress_jumps(stress, weights, result);
    const auto fields = contact_fields(stress, roles, surface, dirichlet, balance);
    add_boundary_residual(stress, roles, balance, fields, weights, result);
    return result;
  }


  template class ResidualEstimate<2>;
  template class ResidualEstimate<3>;
} // namespace signorini
