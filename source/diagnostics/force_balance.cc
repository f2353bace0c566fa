// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/force_balance.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  template <int dim>
  void ForceBalance<dim>::start(const Discretization<dim> &new_discretization,
                                const State               &state,
                                const Vector              *load)
  {
    discretization = &new_discretization;
    body_of_node   = discretization->bodies_of_nodes();
    if (discretization->mesh().is_damped())
      {
        Vector ones = discretization->make_vector();
        ones        = 1.;
        node_masses = ones;
        discretization->matrices().apply_mass(node_masses, ones);
      }
    before = sums(state, load, nullptr);
  }


  template <int dim>
  std::vector<typename ForceBalance<dim>::Sums>
  ForceBalance<dim>::sums(const State &state, const Vector *load, const Vector *support) const
  {
    Vector moved_mass;
    if (node_masses.size() > 0)
      {
        moved_mass = state.displacement;
        moved_mass.scale(node_masses);
      }
    constexpr unsigned int n_vectors          = 5;
    const Vector          *vectors[n_vectors] = {&state.momentum,
                                                 &state.contact_force,
                                                 load,
                                                 support,
                                        moved_mass.size() > 0 ? &moved_mass : nullptr};
    const unsigned int     n_bodies           = discretization->mesh().bodies().size();
    std::vector<double>    numbers(3 * n_vectors * n_bodies, 0.);
    for (unsigned int node = 0; node < body_of_node.size(); ++node)
      if (body_of_node[node] < n_bodies) // a hanging one has no forces
        for (unsigned int v = 0; v < n_vectors; ++v)
          for (unsigned int c = 0; c < dim && vectors[v] != nullptr; ++c)
            numbers[3 * (n_vectors * body_of_node[node] + v) + c] +=
              vectors[v]->local_element(dim * node + c);
    dealii::Utilities::MPI::sum(numbers, discretization->communicator(), numbers);
    std::vector<Sums> result(n_bodies);
    const double     *next = numbers.data();
    for (Sums &body : result)
      for (auto *vector :
           {&body.momentum, &body.contact, &body.load, &body.support, &body.moved_mass})
        {
          std::copy_n(next, 3, vector->begin());
          next += 3;
        }
    return result;
  }


  template <int dim>
  std::vector<ContactForceOnBody>
  ForceBalance<dim>::step(const State &state, const StepReport &report, const Vector *load)
  {
    const Vector *support = report.support_force.size() > 0 ? &report.support_force : nullptr;
    const std::vector<Sums>         now = sums(state, load, support);
    std::vector<ContactForceOnBody> forces(now.size());
    for (std::size_t b = 0; b < now.size(); ++b)
      {
        // At the end of the step, or the mean over it.
        const double weight  = balance == StepBalance::end ? 1. : 0.5;
        const double damping = discretization->mesh().bodies()[b].material.damping.mass;
        const auto   mean    = [&](const double start, const double end) {
          return (1. - weight) * start + weight * end;
        };
        double scale_square = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double inertia =
              has_inertia ? (now[b].momentum[c] - before[b].momentum[c]) / report.step_size : 0.;
            // Damping acts on the velocity with which the nodes have moved in the step.
            const double moved =
              (now[b].moved_mass[c] - before[b].moved_mass[c]) / report.step_size;
            const double other =
              mean(before[b].load[c], now[b].load[c]) + now[b].support[c] - damping * moved;
            double force = inertia - other;
            if (balance == StepBalance::both_ends) // it is the mean of the forces of both ends
              force = 2. * force - before[b].contact[c];
            forces[b].by_multiplier[c] = now[b].contact[c];
            forces[b].by_momentum[c]   = force;
            scale_square               = std::max(scale_square, inertia * inertia + other * other);
          }
        forces[b].momentum_scale = std::sqrt(scale_square);
      }
    before = now;
    return forces;
  }


  template class ForceBalance<2>;
  template class ForceBalance<3>;
} // namespace signorini
