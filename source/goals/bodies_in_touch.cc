// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/contact_status.h>
#include <signorini/contact/own_forces.h>
#include <signorini/goals/bodies_in_touch.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace signorini
{
  template <int dim>
  std::vector<bool> bodies_in_touch(const Discretization<dim> &discretization,
                                    const ContactSurface<dim> &surface,
                                    const State               &state,
                                    const double               soon)
  {
    const Mesh<dim> &mesh  = discretization.mesh();
    double           ahead = soon;
    for (unsigned int b = 0; b < mesh.bodies().size(); ++b)
      ahead =
        std::max(ahead, 2. * mesh.body_size(b) / mesh.bodies()[b].material.pressure_wave_speed());
    Vector then = state.displacement;
    then.add(ahead, state.velocity);

    std::vector<unsigned int> touches(mesh.bodies().size(), 0);
    const auto                note = [&](const unsigned int pair) {
      touches[surface.pairs()[pair].slave] = 1;
      if (surface.pairs()[pair].of_two_bodies())
        touches[surface.pairs()[pair].master] = 1;
    };
    const double round_off = gap_round_off(mesh.body_size());
    for (const ContactNode<dim> &node : surface.near_nodes_at(state.time + ahead, then, round_off))
      if (node.gap <= round_off)
        note(node.pair);
    if (state.contact_force.size() > 0)
      {
        const Vector own = own_forces(surface, state.contact_force);
        for (const ContactNode<dim> &node : surface.nodes())
          if (is_pressed(node.normal_force(own)))
            note(node.pair);
      }
    dealii::Utilities::MPI::max(touches, discretization.communicator(), touches);
    return std::vector<bool>(touches.begin(), touches.end());
  }


  template std::vector<bool>
  bodies_in_touch(const Discretization<2> &, const ContactSurface<2> &, const State &, double);
  template std::vector<bool>
  bodies_in_touch(const Discretization<3> &, const ContactSurface<3> &, const State &, double);
} // namespace signorini
