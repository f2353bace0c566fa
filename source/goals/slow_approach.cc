// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
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

    /** Beside the sum of the sizes of nodal forces: of bodies whose forces cancel. */
    constexpr double round_off = 1e-6;


    /** Of each body. */
    template <int dim>
    struct Sums
    {
      std::vector<dealii::Tensor<1, dim>> force; ///< of contact along its normals
      std::vector<dealii::Tensor<1, dim>> momentum;
      double                              size                   = 0.; ///< of all nodal forces
      bool                                at_obstacle_on_its_way = false;
    };

    template <int dim>
    Sums<dim> sums_over_bodies(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const State               &state)
    {
      const unsigned int  n_bodies = discretization.mesh().bodies().size();
      std::vector<double> numbers(2 * dim * n_bodies + 2, 0.); // forces, momenta, the rest
      const auto          add = [&](const unsigned int body, const dealii::Tensor<1, dim> &force) {
        for (unsigned int c = 0; c < dim; ++c)
          numbers[dim * body + c] += force[c];
      };
      const Vector own = own_forces(surface, state.contact_force);
      for (const ContactNode<dim> &node : surface.nodes())
        if (const double size = node.transmission * node.normal_force(own); size != 0.)
          {
            const PairDescription &pair = surface.pairs()[node.pair];
            add(pair.slave, size * node.normal());
            if (pair.of_two_bodies())
              add(pair.master, -size * node.normal());
            else if (!surface.at_obstacles().obstacle(node.pair).is_at_rest())
              numbers.back() += 1.;
            numbers[numbers.size() - 2] += std::abs(size);
          }
      const std::vector<unsigned int> bodies = discretization.bodies_of_nodes();
      for (unsigned int node = 0; node < bodies.size(); ++node)
        if (bodies[node] < n_bodies) // a hanging one has no momentum
          for (unsigned int c = 0; c < dim; ++c)
            numbers[dim * (n_bodies + bodies[node]) + c] +=
              state.momentum.local_element(dim * node + c);
      dealii::Utilities::MPI::sum(numbers, discretization.communicator(), numbers);

      Sums<dim> result{std::vector<dealii::Tensor<1, dim>>(n_bodies),
                       std::vector<dealii::Tensor<1, dim>>(n_bodies),
                       numbers[numbers.size() - 2],
                       numbers.back() > 0.};
      for (unsigned int body = 0; body < n_bodies; ++body)
        for (unsigned int c = 0; c < dim; ++c)
          {
            result.force[body][c]    = numbers[dim * body + c];
            result.momentum[body][c] = numbers[dim * (n_bodies + body) + c];
          }
      return result;
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
                                 const ContactSurface<dim> &surface,
                                 const State               &state,
                                 const std::vector<double> &masses)
  {
    const Sums<dim> sums = sums_over_bodies(discretization, surface, state);
    if (sums.at_obstacle_on_its_way)
      return 0.;
    double power = 0., compliance = 0., largest = 0., wave_speed = infinity;
    for (unsigned int body = 0; body < masses.size(); ++body)
      if (const auto &description = discretization.mesh().bodies()[body];
          sums.force[body].norm() > round_off * sums.size && description.dirichlet.empty())
        {
          power += sums.force[body] * sums.momentum[body] / masses[body];
          compliance += sums.force[body].norm_square() / masses[body];
          largest    = std::max(largest, sums.force[body].norm());
          wave_speed = std::min(wave_speed, description.material.pressure_wave_speed());
        }
    const bool is_slow = -power < slow * wave_speed * largest;
    return power < 0. && is_slow ? power * power / (2. * compliance) : 0.;
  }


#define INSTANTIATE(dim)                                                                           \
  template std::vector<double> body_masses(const Mesh<dim> &);                                     \
  template double              energy_of_slow_approach(const Discretization<dim> &,                \
                                                       const ContactSurface<dim> &,                \
                                                       const State &,                              \
                                                       const std::vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
