// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/contact_diagnostics.h>
#include <signorini/diagnostics/counted_nodes.h>
#include <signorini/diagnostics/friction_reading.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  template <int dim>
  ContactSummary contact_summary(const ContactSurface<dim> &surface,
                                 const Discretization<dim> &discretization,
                                 const State               &state)
  {
    const MPI_Comm            communicator = discretization.communicator();
    const std::vector<double> gap          = surface.distance(state.displacement);
    const Vector              own          = own_forces(surface, state.contact_force);
    const FrictionState       of_nodes     = own_friction(surface, state.friction);
    const double              round_off = force_of_round_off(surface, discretization, state, own);
    ContactSummary            summary;
    for (unsigned int k = 0; k < gap.size(); ++k)
      {
        const ContactNode<dim>      &node     = surface.nodes()[k];
        const double                 force    = node.normal_force(own);
        const dealii::Tensor<1, dim> all      = node.force(own);
        const FrictionReading<dim>   friction = friction_at(surface, of_nodes, k);
        summary.normal_force += std::abs(node.transmission * force);
        summary.friction_force += node.transmission * friction.force.norm();
        for (unsigned int c = 0; c < dim; ++c)
          summary.resultant[c] += node.transmission * all[c];
        const bool is_active = std::abs(force) > round_off;
        summary.n_active += is_active;
        summary.n_stick += (is_active && friction.status == contact_status::stick);
        summary.n_slip += (is_active && friction.status == contact_status::slip);
        summary.max_slip           = std::max(summary.max_slip, friction.slip_path);
        summary.max_tension        = std::max(summary.max_tension, force);
        summary.largest_node_force = std::max(summary.largest_node_force, std::abs(force));
        summary.max_penetration    = std::max(summary.max_penetration, -gap[k]);
      }
    summary.normal_force   = dealii::Utilities::MPI::sum(summary.normal_force, communicator);
    summary.n_active       = dealii::Utilities::MPI::sum(summary.n_active, communicator);
    summary.friction_force = dealii::Utilities::MPI::sum(summary.friction_force, communicator);
    summary.n_stick        = dealii::Utilities::MPI::sum(summary.n_stick, communicator);
    summary.n_slip         = dealii::Utilities::MPI::sum(summary.n_slip, communicator);
    summary.max_slip       = dealii::Utilities::MPI::max(summary.max_slip, communicator);
    summary.max_tension    = dealii::Utilities::MPI::max(summary.max_tension, communicator);
    summary.largest_node_force =
      dealii::Utilities::MPI::max(summary.largest_node_force, communicator);
    summary.max_penetration = dealii::Utilities::MPI::max(summary.max_penetration, communicator);
    summary.n_nodes         = surface.n_global_nodes();
    summary.depths          = surface.geometric_penetration(state.displacement);
    summary.geometric_penetration = *std::max_element(summary.depths.begin(), summary.depths.end());
    summary.slidings = surface.largest_sliding(state.displacement, state.contact_force);
    for (double &component : summary.resultant)
      component = dealii::Utilities::MPI::sum(component, communicator);
    return summary;
  }


  template ContactSummary
  contact_summary(const ContactSurface<2> &, const Discretization<2> &, const State &);
  template ContactSummary
  contact_summary(const ContactSurface<3> &, const Discretization<3> &, const State &);
} // namespace signorini
