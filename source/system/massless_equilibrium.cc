// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/system/massless_equilibrium.h>
#include <signorini/system/scales.h>

#include <cmath>
#include <limits>

namespace signorini
{
  template <int dim>
  MasslessEquilibrium<dim>::MasslessEquilibrium(const Discretization<dim>     &discretization,
                                                const ContactSurface<dim>     &surface,
                                                const ContactCoordinates<dim> &coordinates,
                                                const SolverParameters        &parameters)
    : discretization(discretization)
    , surface(surface)
    , coordinates(coordinates)
    , stiffness(discretization.matrices(), coordinates, {0., 1.})
    // The surface alone is left: a small problem, and its diagonal is known without a factor.
    , preconditioner(make_preconditioner(PreconditionerKind::jacobi,
                                         discretization.matrices(),
                                         coordinates,
                                         {0., 1.}))
    , solver(parameters.limits)
    , active(surface.nodes().size(), 0)
  {
    const auto       &matrices = discretization.matrices();
    std::vector<char> is_free(dim * matrices.pattern.n_owned, 0);
    for (const unsigned int node : matrices.massless_nodes)
      for (unsigned int c = 0; c < dim; ++c)
        is_free[dim * node + c] = 1;
    for (const unsigned int entry : coordinates.dirichlet_entries())
      is_free[entry] = 0;
    for (unsigned int i = 0; i < is_free.size(); ++i)
      if (!is_free[i])
        fixed_entries.push_back(i);
  }


  template <int dim>
  SolveReport MasslessEquilibrium<dim>::solve(Vector       &displacement,
                                              const Vector &load,
                                              const double  energy_scale,
                                              Vector       &contact_force)
  {
    AssertDimension(displacement.locally_owned_size(), load.locally_owned_size());
    AssertDimension(load.locally_owned_size(), dim * discretization.matrices().pattern.n_owned);
    Assert(energy_scale >= 0., dealii::ExcMessage("The scale is an energy of motion."));
    Vector right_hand_side = discretization.make_vector(), increment = right_hand_side,
           residual = right_hand_side;
    discretization.matrices().apply_stiffness(right_hand_side, displacement);
    right_hand_side.sadd(-1., 1., load);
    coordinates.force_to_contact(right_hand_side);
    const std::vector<double> gap = surface.normal_gap(displacement),
                              zeros(fixed_entries.size(), 0.);
    // A body at rest that begins to be loaded has no energy yet.
    const double scale =
      energy_scale > 0.
        ? std::sqrt(energy_scale)
        : response_size(stiffness, *preconditioner, right_hand_side, fixed_entries, zeros);
    const SolveReport report =
      solver.solve({stiffness,
                    *preconditioner,
                    right_hand_side,
                    coordinates.normal_entries(),
                    gap,
                    fixed_entries,
                    zeros,
                    std::max(1e-12 * scale, std::numeric_limits<double>::min()),
                    1e-13 * discretization.mesh().body_size()},
                   active,
                   increment,
                   residual);
    contact_force = coordinates.normal_reaction(active, residual);
    coordinates.force_to_cartesian(contact_force);
    coordinates.displacement_to_cartesian(increment);
    displacement += increment;
    return report;
  }


  template class MasslessEquilibrium<2>;
  template class MasslessEquilibrium<3>;
} // namespace signorini
