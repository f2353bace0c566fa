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
      bool                                touches_moving_obstacle = false; ///< any of them
    };

    template <int dim>
    Sums<dim> sums_over_bodies(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const State               &state)
    {
      const unsigned int n_bodies = discretization.mesh().bodies().size();
      Sums<dim>          sums{std::vector<dealii::Tensor<1, dim>>(n_bodies),
                     std::vector<dealii::Tensor<1, dim>>(n_bodies)};
      const Vector       own = own_forces(surface, state.contact_force);
      for (const ContactNode<dim> &node : surface.nodes())
        if (const double size = node.transmission * node.normal_force(own); size != 0.)
          {
            const PairDescription &pair = surface.pairs()[node.pair];
            sums.force[pair.slave] += size * node.normal();
            if (pair.of_two_bodies())
              sums.force[pair.master] -= size * node.normal();
            else if (!surface.at_obstacles().obstacle(node.pair).is_at_rest())
              sums.touches_moving_obstacle = true;
          }
      const std::vector<unsigned int> bodies = discretization.bodies_of_nodes();
      for (unsigned int node = 0; node < bodies.size(); ++node)
        if (bodies[node] < n_bodies) // a hanging one has no momentum
          for (unsigned int c = 0; c < dim; ++c)
            sums.momentum[bodies[node]][c] += state.momentum.local_element(dim * node + c);

      const MPI_Comm communicator = discretization.communicator();
      for (auto *vectors : {&sums.force, &sums.momentum})
        for (auto &vector : *vectors)
          vector = dealii::Utilities::MPI::sum(vector, communicator);
      sums.touches_moving_obstacle =
        dealii::Utilities::MPI::logical_or(sums.touches_moving_obstacle, communicator);
      return sums;
    }
  } // namespace


  template <int dim>
  std::vector<double> body_masses(const Mesh<dim> &mesh)
  {
    std::vector<double> masses = mesh.volumes_of_bodies();
    for (unsigned int body = 0; body < masses.size(); ++body)
      masses[body] *= mesh.bodies()[body].material.density;
    return masses;
  }


  template <int dim>
  double energy_of_slow_approach(const Discretization<dim> &discretization,
                                 const ContactSurface<dim> &surface,
                                 const State               &state,
                                 const std::vector<double> &masses,
                                 const double               force)
  {
    const Sums<dim> sums = sums_over_bodies(discretization, surface, state);
    if (sums.touches_moving_obstacle)
      return 0.;
    double power = 0., compliance = 0., largest = 0.;
    double wave_speed = std::numeric_limits<double>::infinity();
    for (unsigned int body = 0; body < masses.size(); ++body)
      if (const auto &description = discretization.mesh().bodies()[body];
          sums.force[body].norm() > round_off * force && description.dirichlet.empty())
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
                                                       const std::vector<double> &,                \
                                                       double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
