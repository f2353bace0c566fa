// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/error_norms.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  ErrorNorms ErrorEvaluation<dim>::evaluate(const State &state, const double weight)
  {
    const auto &exact       = discretization.scene.exact_solution;
    const auto [u, u_exact] = squares(exact.displacement, state.displacement, state.time);
    const auto [v, v_exact] = squares(exact.velocity, state.velocity, state.time);
    const auto ratio        = [](const double a, const double b) { return b > 0. ? std::sqrt(a / b) : 0.; };
    displacement_errors += weight * u;
    displacement_norms += weight * u_exact;
    velocity_errors += weight * v;
    velocity_norms += weight * v_exact;
    return {std::sqrt(u),
            std::sqrt(v),
            std::sqrt(u_exact),
            std::sqrt(v_exact),
            ratio(displacement_errors, displacement_norms),
            ratio(velocity_errors, velocity_norms)};
  }


  template <int dim>
  std::pair<double, double>
  ErrorEvaluation<dim>::squares(const std::array<std::string, dim> &exact, const Vector &field, const double time) const
  {
    const std::vector<std::array<std::string, dim>> everywhere(discretization.scene.bodies.size(), exact);
    Vector exact_field = discretization.interpolate(everywhere, time), product = discretization.make_vector();
    discretization.matrices.apply_mass(product, exact_field);
    const double norm = exact_field * product;
    exact_field -= field;
    discretization.matrices.apply_mass(product, exact_field);
    return {std::max(0., exact_field * product), std::max(0., norm)};
  }


  template class ErrorEvaluation<2>;
  template class ErrorEvaluation<3>;
} // namespace signorini
