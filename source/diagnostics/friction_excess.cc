// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/friction_excess.h>
#include <signorini/diagnostics/friction_reading.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace signorini
{
  template <int dim>
  double friction_excess(const ContactSurface<dim> &surface,
                         const State               &state,
                         const MPI_Comm             communicator)
  {
    if (!state.friction.any())
      return 0.;
    const Vector        own      = own_forces(surface, state.contact_force);
    const FrictionState friction = own_friction(surface, state.friction);
    double              excess   = 0.;
    for (unsigned int k = 0; k < surface.nodes().size(); ++k)
      if (const ContactNode<dim> &node = surface.nodes()[k]; !node.is_shared() && node.row == 0)
        excess = std::max(excess,
                          friction_at(surface, friction, k).force.norm()
                            - node.friction.bound(-node.normal_force(own)));
    return dealii::Utilities::MPI::max(excess, communicator);
  }


  template double friction_excess(const ContactSurface<2> &, const State &, MPI_Comm);
  template double friction_excess(const ContactSurface<3> &, const State &, MPI_Comm);
} // namespace signorini
