// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/diagnostics/probe.h>

#include <deal.II/base/mpi.h>

#include <limits>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  Probe<dim>::Probe(const ProbeDescription<dim> &description,
                    const ContactSurface<dim>   &surface,
                    const MPI_Comm               communicator)
    : probe_name(description.name)
    , communicator(communicator)
  {
    double distance = std::numeric_limits<double>::max();
    for (const ContactNode<dim> &candidate : surface.nodes())
      if (const double d = candidate.position.distance(description.point); d < distance)
        {
          distance = d;
          node     = &candidate;
        }
    if (surface.n_global_nodes() == 0)
      throw UserError("Probes/" + probe_name
                      + ": there is no contact node that it could observe. Check Contact/Pairs, or remove the probe.");
    const auto closest = Utilities::MPI::min_max_avg(distance, communicator);
    owner              = closest.min_index;
    if (Utilities::MPI::this_mpi_process(communicator) != owner)
      node = nullptr;
    node_position = Utilities::MPI::broadcast(communicator, node ? node->position : Point<dim>(), owner);
  }


  template <int dim>
  ProbeReading Probe<dim>::read(const State &state) const
  {
    std::array<double, 4> values{};
    if (node)
      {
        for (unsigned int c = 0; c < dim; ++c)
          {
            values[0] += node->frame[c] * state.displacement.local_element(dim * node->node + c);
            values[1] += node->frame[c] * state.velocity.local_element(dim * node->node + c);
          }
        values[2] = -normal_force(*node, state.contact_force);
        if (values[2] == 0.)
          values[2] = 0.; // no negative zero in tables
        values[3] = node->gap;
      }
    values              = Utilities::MPI::broadcast(communicator, values, owner);
    const double weight = Utilities::MPI::broadcast(communicator, node ? node->weight : 0., owner);
    return {values[3] - values[0], values[0], values[1], values[2] / weight, values[2]};
  }


  template class Probe<2>;
  template class Probe<3>;
} // namespace signorini
