// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/distance_indicator.h>
#include <signorini/adaptivity/kelly_indicator.h>
#include <signorini/adaptivity/residual_indicator.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  std::unique_ptr<ErrorIndicator<dim>> make_error_indicator(const Discretization<dim> &discretization,
                                                            const ContactSurface<dim> &surface,
                                                            const Supports<dim>       &supports)
  {
    const std::string &name = discretization.scene.adaptivity.indicator;
    if (name == "residual")
      return std::make_unique<ResidualIndicator<dim>>(discretization, surface, supports);
    if (name == "kelly")
      return std::make_unique<KellyIndicator<dim>>(discretization);
    if (name == "distance")
      return std::make_unique<DistanceIndicator<dim>>(discretization, surface);
    return nullptr;
  }


  void remove_round_off(const State &state, dealii::Vector<double> &indicator)
  {
    // Steps are solved to about 1e-11 in the energy norm; indicators of what is left may be larger by constants.
    constexpr double round_off = 1e-8;
    const double     energy    = state.velocity * state.momentum + state.displacement * state.internal_force;
    const double     square = dealii::Utilities::MPI::sum(indicator.norm_sqr(), state.velocity.get_mpi_communicator());
    if (square <= round_off * round_off * energy)
      indicator = 0.;
  }


  template std::unique_ptr<ErrorIndicator<2>>
  make_error_indicator(const Discretization<2> &, const ContactSurface<2> &, const Supports<2> &);
  template std::unique_ptr<ErrorIndicator<3>>
  make_error_indicator(const Discretization<3> &, const ContactSurface<3> &, const Supports<3> &);
} // namespace signorini
