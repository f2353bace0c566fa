// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/friction_reading.h>
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
    , surface(&surface)
  {
    double distance = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < surface.nodes().size(); ++k)
      if (const double d = surface.nodes()[k].position.distance(description.point); d < distance)
        {
          distance = d;
          node     = k;
        }
    if (surface.n_global_nodes() == 0)
      throw UserError("Probes/" + probe_name
                      + ": there is no contact node that it could observe. Check Contact/Pairs, or "
                        "remove the probe.");
    const auto closest = Utilities::MPI::min_max_avg(distance, communicator);
    owner              = closest.min_index;
    const bool is_here = Utilities::MPI::this_mpi_process(communicator) == owner;
    node_position      = Utilities::MPI::broadcast(
      communicator, is_here ? surface.nodes()[node].position : Point<dim>(), owner);
    node_pair =
      Utilities::MPI::broadcast(communicator, is_here ? surface.nodes()[node].pair : 0u, owner);
  }


  template <int dim>
  double Probe<dim>::normal_velocity_of_obstacle(const State &state) const
  {
    if (surface->pairs()[node_pair].of_two_bodies())
      return 0.;
    const ContactNode<dim> &contact_node = surface->nodes()[node];
    const auto             &obstacles    = surface->at_obstacles();
    const auto              place = obstacles.displaced(contact_node.node, state.displacement);
    return contact_node.normal() * obstacles.obstacle(node_pair).velocity(place);
  }


  template <int dim>
  ProbeReading Probe<dim>::read(const State &state) const
  {
    const std::vector<double> displacement = surface->relative_normal(state.displacement),
                              velocity     = surface->relative_normal(state.velocity),
                              distance     = surface->distance(state.displacement);
    const Vector        own                = own_forces(*surface, state.contact_force);
    const FrictionState of_nodes           = own_friction(*surface, state.friction);
    ProbeReading        reading;
    if (Utilities::MPI::this_mpi_process(communicator) == owner)
      {
        const ContactNode<dim>    &contact_node = surface->nodes()[node];
        const FrictionReading<dim> friction     = friction_at(*surface, of_nodes, node);
        const double               scale        = contact_node.distance_per_gap();
        // Zero is added: there is no negative zero in tables.
        reading.gap = distance[node] + 0.;
        if (!surface->faces_nothing(node)) // else there is no normal
          {
            reading.normal_displacement = scale * displacement[node] + 0.;
            reading.normal_velocity =
              scale * (velocity[node] - normal_velocity_of_obstacle(state)) + 0.;
          }
        reading.normal_force = -contact_node.normal_force(own) + 0.;
        reading.pressure     = reading.normal_force / contact_node.weight;
        for (unsigned int c = 0; c < dim; ++c)
          {
            reading.tangential_force[c] = friction.force[c] + 0.;
            reading.slip[c]             = friction.accumulated_slip[c] + 0.;
          }
        reading.slip_path = friction.slip_path;
        reading.status    = friction.status;
      }
    return Utilities::MPI::broadcast(communicator, reading, owner);
  }


  template class Probe<2>;
  template class Probe<3>;
} // namespace signorini
