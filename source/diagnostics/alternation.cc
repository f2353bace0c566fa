// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/alternation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  template <int dim>
  WatchedVelocities normal_velocities(const ContactSurface<dim> &surface, const Vector &velocity)
  {
    WatchedVelocities result;
    for (const ContactNode<dim> &node : surface.nodes())
      {
        if (node.row > 0)
          continue; // a second obstacle at the same node, or none yet
        double normal_velocity = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          normal_velocity += node.normal()[c] * velocity.local_element(dim * node.node + c);
        result.values.push_back(normal_velocity);
        result.bodies.push_back(surface.pairs()[node.pair].slave);
      }
    return result;
  }


  template <int dim>
  WatchedVelocities prescribed_velocities(const DirichletConditions<dim> &dirichlet,
                                          const Vector                   &velocity)
  {
    WatchedVelocities result;
    for (const auto &[node, conditions] : dirichlet.nodes())
      for (unsigned int c = 0; c < dim; ++c)
        if (conditions[c] != DirichletConditions<dim>::none && dirichlet.moves(conditions[c], c))
          {
            result.values.push_back(velocity.local_element(dim * node + c));
            result.bodies.push_back(dirichlet.body(conditions[c]));
          }
    return result;
  }


  void Alternation::forget()
  {
    n_added = 0;
  }


  std::vector<double> Alternation::add(const WatchedVelocities &velocities,
                                       const double             typical_speed,
                                       const unsigned int       n_bodies,
                                       const MPI_Comm           communicator)
  {
    fastest.resize(n_bodies, 0.);
    if (n_added == 0)
      for (std::vector<double> *numbers : {&before, &last, &sums})
        numbers->assign(velocities.values.size(), 0.);
    ++n_added;
    for (std::size_t k = 0; k < velocities.values.size(); ++k)
      {
        const double now = velocities.values[k];
        if (n_added > 2)
          {
            sums[k] += (n_added % 2 == 0 ? 1. : -1.) * (now - 2. * last[k] + before[k]) / 4.;
            double &speed = fastest[velocities.bodies[k]];
            speed         = std::max(speed, std::abs(now + 2. * last[k] + before[k]) / 4.);
          }
        before[k] = last[k];
        last[k]   = now;
      }
    if (n_added % n_steps == 0)
      return judge(velocities.bodies, typical_speed, communicator);
    return std::vector<double>(n_bodies, 0.);
  }


  std::vector<double> Alternation::judge(const std::vector<unsigned int> &bodies,
                                         const double                     typical_speed,
                                         const MPI_Comm                   communicator)
  {
    std::vector<double> amplitudes(fastest.size(), 0.);
    for (std::size_t k = 0; k < sums.size(); ++k)
      {
        amplitudes[bodies[k]] = std::max(amplitudes[bodies[k]], std::abs(sums[k]) / n_steps);
        sums[k]               = 0.;
      }
    dealii::Utilities::MPI::max(amplitudes, communicator, amplitudes);
    dealii::Utilities::MPI::max(fastest, communicator, fastest);
    for (std::size_t body = 0; body < amplitudes.size(); ++body)
      if (const double speed = std::max(fastest[body], typical_speed); speed > 0.)
        amplitudes[body] /= speed;
    latest_means.resize(amplitudes.size(), 0.);
    latest_means.swap(amplitudes); // now those of before
    for (std::size_t body = 0; body < amplitudes.size(); ++body)
      amplitudes[body] =
        must_last ? std::min(amplitudes[body], latest_means[body]) : latest_means[body];
    return amplitudes;
  }


#define INSTANTIATE(dim)                                                                           \
  template WatchedVelocities normal_velocities(const ContactSurface<dim> &, const Vector &);       \
  template WatchedVelocities prescribed_velocities(const DirichletConditions<dim> &,               \
                                                   const Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
