// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/node_friction.h>

namespace signorini
{
  template <int dim>
  NodeFriction<dim>
  node_friction(const ContactSurface<dim> &surface, const FrictionState &friction, const unsigned int k)
  {
    NodeFriction<dim> result;
    if (!friction.any())
      return result;
    const ContactNode<dim> &node  = surface.nodes()[k];
    const double            scale = 1. / node.transmission;
    for (unsigned int c = 0; c < dim; ++c)
      {
        const unsigned int entry   = dim * node.node + c;
        result.force[c]            = friction.force.local_element(entry);
        result.slip[c]             = scale * friction.slip.local_element(entry);
        result.accumulated_slip[c] = scale * friction.accumulated_slip.local_element(entry);
      }
    result.slip_path = scale * friction.slip_path[k];
    result.status    = friction.status[k];
    return result;
  }


  template NodeFriction<2> node_friction(const ContactSurface<2> &, const FrictionState &, unsigned int);
  template NodeFriction<3> node_friction(const ContactSurface<3> &, const FrictionState &, unsigned int);
} // namespace signorini
