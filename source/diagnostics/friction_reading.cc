// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/friction_reading.h>

namespace signorini
{
  template <int dim>
  FrictionState own_friction(const ContactSurface<dim> &surface, const FrictionState &friction)
  {
    FrictionState result = friction;
    if (friction.any())
      result.force = own_forces(surface, friction.force);
    return result;
  }


  template <int dim>
  FrictionReading<dim> friction_at(const ContactSurface<dim> &surface,
                                   const FrictionState       &friction,
                                   const unsigned int         k)
  {
    FrictionReading<dim> result;
    if (!friction.any())
      return result;
    const ContactNode<dim> &node = surface.nodes()[k];
    if (node.row > 0)
      return result; // all of it is that of the first row
    const double scale = 1. / node.transmission;
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


  template FrictionReading<2>
  friction_at(const ContactSurface<2> &, const FrictionState &, unsigned int);
  template FrictionReading<3>
  friction_at(const ContactSurface<3> &, const FrictionState &, unsigned int);
  template FrictionState own_friction(const ContactSurface<2> &, const FrictionState &);
  template FrictionState own_friction(const ContactSurface<3> &, const FrictionState &);
} // namespace signorini
