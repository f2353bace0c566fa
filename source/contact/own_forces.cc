// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>

#include <algorithm>
#include <cmath>

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
    // What cancels is nothing, and not the force of a node in contact.
    for (const ContactNode<dim> &node : surface.nodes())
      {
        double own = 0., all = 0.;
        for (unsigned int i = dim * node.node; i < dim * (node.node + 1); ++i)
          {
            own = std::max(own, std::abs(result.local_element(i)));
            all = std::max(all, std::abs(forces.local_element(i)));
          }
        for (unsigned int i = dim * node.node; i < dim * (node.node + 1) && own < 1e-12 * all; ++i)
          result.local_element(i) = 0.;
      }
    return result;
  }


  template Vector own_forces(const ContactSurface<2> &, const Vector &);
  template Vector own_forces(const ContactSurface<3> &, const Vector &);
} // namespace signorini
