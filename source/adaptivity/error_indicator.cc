// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/distance_indicator.h>
#include <signorini/adaptivity/kelly_indicator.h>
#include <signorini/adaptivity/residual_indicator.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  std::unique_ptr<ErrorIndicator<dim>>
  make_error_indicator(const AdaptivityParameters     &parameters,
                       const TimeIntegration          &time,
                       const Discretization<dim>      &discretization,
                       const ContactSurface<dim>      &surface,
                       const DirichletConditions<dim> &dirichlet)
  {
    if (parameters.indicator == IndicatorKind::residual)
      return std::make_unique<ResidualIndicator<dim>>(
        discretization, surface, dirichlet, time, parameters.goal);
    if (parameters.indicator == IndicatorKind::kelly)
      return std::make_unique<KellyIndicator<dim>>(discretization);
    if (parameters.indicator == IndicatorKind::distance)
      return std::make_unique<DistanceIndicator<dim>>(
        discretization, surface, parameters, time.step_size);
    return nullptr;
  }


  void remove_round_off(const State &state, dealii::Vector<double> &indicator)
  {
    // Steps are solved to about 1e-11 in the energy norm; indicators of what is left may be larger
    // by constants.
    constexpr double round_off = 1e-8;
    const double     energy =
      state.velocity * state.momentum + state.displacement * state.internal_force;
    const double square =
      dealii::Utilities::MPI::sum(indicator.norm_sqr(), state.velocity.get_mpi_communicator());
    if (square <= round_off * round_off * energy)
      indicator = 0.;
  }


#define INSTANTIATE(dim)                                                                           \
  template std::unique_ptr<ErrorIndicator<dim>> make_error_indicator(                              \
    const AdaptivityParameters &,                                                                  \
    const TimeIntegration &,                                                                       \
    const Discretization<dim> &,                                                                   \
    const ContactSurface<dim> &,                                                                   \
    const DirichletConditions<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
