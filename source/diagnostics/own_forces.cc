// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/own_forces.h>

namespace signorini
{
  template <int dim>
  Vector own_forces(const ContactSurface<dim> &surface, const Vector &forces)
  {
    const NodeCoupling<dim> &coupling = surface.coupling();
    Vector                   result   = forces;
    if (!surface.follows())
      return result;
    const auto &entries = coupling.relative_entries();
    for (unsigned int level = coupling.n_levels(); level > 0; --level)
      {
        std::vector<double> handed_on(entries.size(), 0.);
        for (std::size_t r = 0; r < entries.size(); ++r)
          if (const std::size_t k = coupling.nodes_of_relative_entries()[r];
              coupling.level(k) == level)
            handed_on[r] = surface.nodes()[k].component(entries[r] % dim, result);
        coupling.add_to_partners(handed_on, result);
      }
    return result;
  }


  template <int dim>
  FrictionState own_friction(const ContactSurface<dim> &surface, const FrictionState &friction)
  {
    FrictionState result = friction;
    if (friction.any())
      result.force = own_forces(surface, friction.force);
    return result;
  }


  template Vector        own_forces(const ContactSurface<2> &, const Vector &);
  template Vector        own_forces(const ContactSurface<3> &, const Vector &);
  template FrictionState own_friction(const ContactSurface<2> &, const FrictionState &);
  template FrictionState own_friction(const ContactSurface<3> &, const FrictionState &);
} // namespace signorini
