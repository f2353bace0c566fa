// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_error_norms_h
#define signorini_diagnostics_error_norms_h

#include <signorini/base/archive.h>
#include <signorini/discretization/discretization.h>
#include <signorini/model/exact_solution.h>
#include <signorini/time/state.h>

namespace signorini
{
  /** Errors against an exact solution, in the norm of the mass matrix. */
  struct ErrorNorms
  {
    double displacement      = 0.; ///< norm of u - I u(t), I the nodal interpolation
    double velocity          = 0.; ///< norm of v - I v(t)
    double displacement_norm = 0.; ///< norm of I u(t)
    double velocity_norm     = 0.; ///< norm of I v(t)
    /**
     * (integral of squared errors so far / integral of squared norms so far)^(1/2), by the
     * trapezoidal rule in time; at the start the values there.
     */
    double relative_displacement = 0.;
    double relative_velocity     = 0.;
  };

  /** Evaluates an exact solution step by step. */
  template <int dim>
  class ErrorEvaluation
  {
  public:
    explicit ErrorEvaluation(const ExactSolutionDescription<dim> &exact)
      : exact(exact)
    {
    }

    /** @param step_size of the step that has ended; 0 for the initial state */
    ErrorNorms
    evaluate(const Discretization<dim> &discretization, const State &state, double step_size);

    /** The integrals so far. */
    void archive(Archive &archive) { archive(displacement, velocity); }

  private:
    /** Squared norms at one instant, and their integral over time. */
    struct Squares
    {
      double error = 0., norm = 0., error_integral = 0., norm_integral = 0.;

      void   advance(const std::pair<double, double> &error_and_norm, double step_size);
      double relative() const;
    };

    const ExactSolutionDescription<dim> exact;
    Squares                             displacement, velocity;

    /** Squared norms of the error of a field and of its exact interpolant. */
    static std::pair<double, double> squares(const Discretization<dim>          &discretization,
                                             const std::array<std::string, dim> &exact,
                                             const Vector                       &field,
                                             double                              time);
  };
} // namespace signorini

#endif
