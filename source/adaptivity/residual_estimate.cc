// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/contact_fields.h>
#include <signorini/adaptivity/residual_estimate.h>

namespace signorini
{
  template <int dim>
  dealii::Vector<double> squared_residual_estimate(const Discretization<dim> &discretization,
                                                   const ContactSurface<dim> &surface,
                                                   const Supports<dim>       &supports,
                                                   const ForceBalance        &balance,
                                                   const ResidualWeights     &weights)
  {
    dealii::Vector<double> squares(discretization.triangulation.n_active_cells());
    const Vector           u = discretization.interpolate_hanging_nodes(balance.displacement);
    add_interior_residual(
      discretization, u, discretization.interpolate_hanging_nodes(balance.specific_force), weights, squares);
    add_stress_jumps(discretization, u, weights, squares);
    add_boundary_residual(discretization,
                          surface,
                          balance,
                          u,
                          contact_fields(discretization, surface, supports, balance, u),
                          weights,
                          squares);
    return squares;
  }


  template dealii::Vector<double> squared_residual_estimate(const Discretization<2> &,
                                                            const ContactSurface<2> &,
                                                            const Supports<2> &,
                                                            const ForceBalance &,
                                                            const ResidualWeights &);
  template dealii::Vector<double> squared_residual_estimate(const Discretization<3> &,
                                                            const ContactSurface<3> &,
                                                            const Supports<3> &,
                                                            const ForceBalance &,
                                                            const ResidualWeights &);
} // namespace signorini
