// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_error_norms_h
#define signorini_diagnostics_error_norms_h

#include <signorini/discretization/discretization.h>
#include <signorini/time/state.h>

namespace signorini
{
  /** Errors against the exact solution of the scene, in the norm of the mass matrix. */
  struct ErrorNorms
  {
    double displacement      = 0.; ///< norm of u - I u(t), I the nodal interpolation
    double velocity          = 0.; ///< norm of v - I v(t)
    double displacement_norm = 0.; ///< norm of I u(t)
    double velocity_norm     = 0.; ///< norm of I v(t)
    /** (sum of squared errors so far / sum of squared norms so far)^(1/2), weighted by the sizes of the steps. */
    double relative_displacement = 0.;
    double relative_velocity     = 0.;
  };

  /** Evaluates the exact solution of a scene step by step. */
  template <int dim>
  class ErrorEvaluation
  {
  public:
    explicit ErrorEvaluation(const Discretization<dim> &discretization)
      : discretization(discretization)
    {
    }

    /** @param weight the size of the step that has ended; of the initial state, that of the first step */
    ErrorNorms evaluate(const State &state, double weight);

  private:
    const Discretization<dim> &discretization;
    double displacement_errors = 0., displacement_norms = 0., velocity_errors = 0., velocity_norms = 0.;

    /** Squared norms of the error of a field and of its exact interpolant. */
    std::pair<double, double>
    squares(const std::array<std::string, dim> &exact, const Vector &field, double time) const;
  };
} // namespace signorini

#endif
