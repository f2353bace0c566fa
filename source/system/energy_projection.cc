// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/preconditioners.h>
#include <signorini/system/energy_projection.h>
#include <signorini/variational_inequality/primal_dual_active_set.h>

namespace signorini
{
  namespace
  {
    /** Squared frequency far below the lowest one of any body that keeps its shape. */
    template <int dim>
    double negligible_frequency_square(const Discretization<dim> &discretization)
    {
      double slowest = std::numeric_limits<double>::max();
      for (const auto &body : discretization.mesh().bodies())
        slowest = std::min(slowest, body.material.pressure_wave_speed());
      return 1e-8 * std::pow(slowest / discretization.mesh().body_size(), 2);
    }
  } // namespace


  template <int dim>
  Vector project_in_energy(const Discretization<dim>     &discretization,
                           const ContactCoordinates<dim> &coordinates,
                           const Vector                  &error_moments,
                           const std::vector<double>     &bounds,
                           const double                   size,
                           const SolverParameters        &limits)
  {
    const double            mass_factor = negligible_frequency_square(discretization);
    const StepOperator<dim> matrix(discretization.matrices(), coordinates, mass_factor, 1.);
    const std::unique_ptr<MaskedPreconditioner> preconditioner = make_preconditioner(
      PreconditionerKind::jacobi, discretization.matrices(), coordinates, mass_factor, 1.);
    PrimalDualActiveSet solver(
      {limits.maximum_active_set_iterations, limits.maximum_linear_iterations});

    Vector right_hand_side = error_moments, correction = discretization.make_vector(),
           residual = correction;
    coordinates.force_to_contact(right_hand_side);
    const std::vector<double> nothing(coordinates.dirichlet_entries().size(), 0.);
    ActiveSet                 active(bounds.size(), contact_status::open);
    solver.solve({matrix,
                  *preconditioner,
                  right_hand_side,
                  coordinates.normal_entries(),
                  bounds,
                  coordinates.dirichlet_entries(),
                  nothing,
                  1e-12 * size,
                  1e-14 * discretization.mesh().body_size()},
                 active,
                 correction,
                 residual);
    coordinates.displacement_to_cartesian(correction);
    return correction;
  }


#define INSTANTIATE(dim)                                                                           \
  template Vector project_in_energy(const Discretization<dim> &,                                   \
                                    const ContactCoordinates<dim> &,                               \
                                    const Vector &,                                                \
                                    const std::vector<double> &,                                   \
                                    double,                                                        \
                                    const SolverParameters &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
