// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/goals/slow_approach.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /** In units of the speed of a pressure wave. */
    constexpr double slow = 1. / 300.;

    /** The sum of nodal forces or momenta of each body, dim numbers one after another. */
    template <int dim>
    std::vector<double> sums_over_bodies(const Discretization<dim>       &discretization,
                                         const std::vector<unsigned int> &body_of_node,
                                         const Vector                    &vector)
    {
      std::vector<double> sums(dim * discretization.mesh().bodies().size(), 0.);
      for (unsigned int node = 0; node < body_of_node.size(); ++node)
        if (dim * body_of_node[node] < sums.size()) // a hanging one has none
          for (unsigned int c = 0; c < dim; ++c)
            sums[dim * body_of_node[node] + c] += vector.local_element(dim * node + c);
      dealii::Utilities::MPI::sum(sums, discretization.communicator(), sums);
      return sums;
    }
  } // namespace


  template <int dim>
  std::vector<double> body_masses(const Mesh<dim> &mesh)
  {
    std::vector<double> masses(mesh.bodies().size(), 0.);
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        masses[cell->material_id()] +=
          mesh.bodies()[cell->material_id()].material.density * cell->measure();
    dealii::Utilities::MPI::sum(masses, mesh.communicator(), masses);
    return masses;
  }


  template <int dim>
  double energy_of_slow_approach(const Discretization<dim> &discretization,
                                 const State               &state,
                                 const std::vector<double> &masses)
  {
    const auto bodies   = discretization.bodies_of_nodes();
    const auto force    = sums_over_bodies(discretization, bodies, state.contact_force);
    const auto momentum = sums_over_bodies(discretization, bodies, state.momentum);
    double     power = 0., compliance = 0., largest = 0., wave_speed = infinity;
    for (unsigned int body = 0; body < masses.size(); ++body)
      {
        double square = 0.;
        for (unsigned int i = dim * body; i < dim * (body + 1); ++i)
          {
            power += force[i] * momentum[i] / masses[body];
            square += force[i] * force[i];
          }
        compliance += square / masses[body];
        largest = std::max(largest, std::sqrt(square));
        if (square > 0.)
          wave_speed = std::min(
            wave_speed, discretization.mesh().bodies()[body].material.pressure_wave_speed());
      }
    const bool is_slow = -power < slow * wave_speed * largest;
    return power < 0. && is_slow ? power * power / (2. * compliance) : 0.;
  }


#define INSTANTIATE(dim)                                                                           \
  template std::vector<double> body_masses(const Mesh<dim> &);                                     \
  template double              energy_of_slow_approach(                                            \
                 const Discretization<dim> &, const State &, const std::vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
