// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/error_norms.h>

#include <cmath>
#include <tuple>

namespace signorini
{
  template <int dim>
  void ErrorEvaluation<dim>::Squares::advance(const std::pair<double, double> &error_and_norm,
                                              const double                     step_size)
  {
    error_integral += step_size / 2. * (error + error_and_norm.first);
    norm_integral += step_size / 2. * (norm + error_and_norm.second);
    std::tie(error, norm) = error_and_norm;
  }


  template <int dim>
  double ErrorEvaluation<dim>::Squares::relative() const
  {
    if (norm_integral > 0.)
      return std::sqrt(error_integral / norm_integral);
    return norm > 0. ? std::sqrt(error / norm) : 0.;
  }


  template <int dim>
  ErrorNorms ErrorEvaluation<dim>::evaluate(const Discretization<dim> &discretization,
                                            const State               &state,
                                            const double               step_size)
  {
    displacement.advance(
      squares(discretization, exact.displacement, state.displacement, state.time), step_size);
    velocity.advance(squares(discretization, exact.velocity, state.velocity, state.time),
                     step_size);
    return {std::sqrt(displacement.error),
            std::sqrt(velocity.error),
            std::sqrt(displacement.norm),
            std::sqrt(velocity.norm),
            displacement.relative(),
            velocity.relative()};
  }


  template <int dim>
  std::pair<double, double> ErrorEvaluation<dim>::squares(const Discretization<dim> &discretization,
                                                          const std::array<std::string, dim> &exact,
                                                          const Vector                       &field,
                                                          const double                        time)
  {
    const std::vector<std::array<std::string, dim>> everywhere(
      discretization.mesh().bodies().size(), exact);
    Vector exact_field = discretization.interpolate(everywhere, time),
           product     = discretization.make_vector();
    discretization.matrices().apply_mass(product, exact_field);
    const double norm = exact_field * product;
    exact_field -= field;
    discretization.matrices().apply_mass(product, exact_field);
    return {std::max(0., exact_field * product), std::max(0., norm)};
  }


  template class ErrorEvaluation<2>;
  template class ErrorEvaluation<3>;
} // namespace signorini
