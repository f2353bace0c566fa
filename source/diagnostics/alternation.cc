// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/alternation.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  void Alternation<dim>::forget()
  {
    n_added = 0;
  }


  template <int dim>
  std::vector<double> Alternation<dim>::add(const ContactSurface<dim> &surface,
                                            const Vector              &velocity,
                                            const double               typical_speed,
                                            const unsigned int         n_bodies,
                                            const MPI_Comm             communicator)
  {
    const auto &nodes = surface.nodes();
    fastest.resize(n_bodies, 0.);
    if (n_added == 0)
      for (std::vector<double> *numbers : {&before, &last, &sums})
        numbers->assign(nodes.size(), 0.);
    ++n_added;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        if (nodes[k].row > 0)
          continue; // a second obstacle at the same node, or none yet
        double now = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          now += nodes[k].normal()[c] * velocity.local_element(dim * nodes[k].node + c);
        if (n_added > 2)
          {
            sums[k] += (n_added % 2 == 0 ? 1. : -1.) * (now - 2. * last[k] + before[k]) / 4.;
            double &speed = fastest[surface.pairs()[nodes[k].pair].slave];
            speed         = std::max(speed, std::abs(now + 2. * last[k] + before[k]) / 4.);
          }
        before[k] = last[k];
        last[k]   = now;
      }
    if (n_added % n_steps == 0)
      return judge(surface, typical_speed, communicator);
    return std::vector<double>(n_bodies, 0.);
  }


  template <int dim>
  std::vector<double> Alternation<dim>::judge(const ContactSurface<dim> &surface,
                                              const double               typical_speed,
                                              const MPI_Comm             communicator)
  {
    std::vector<double> amplitudes(fastest.size(), 0.);
    for (std::size_t k = 0; k < sums.size(); ++k)
      {
        double &amplitude = amplitudes[surface.pairs()[surface.nodes()[k].pair].slave];
        amplitude         = std::max(amplitude, std::abs(sums[k]) / n_steps);
        sums[k]           = 0.;
      }
    dealii::Utilities::MPI::max(amplitudes, communicator, amplitudes);
    dealii::Utilities::MPI::max(fastest, communicator, fastest);
    for (std::size_t body = 0; body < amplitudes.size(); ++body)
      if (const double speed = std::max(fastest[body], typical_speed); speed > 0.)
        amplitudes[body] /= speed;
    return amplitudes;
  }


  template class Alternation<2>;
  template class Alternation<3>;
} // namespace signorini
