// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_contact_diagnostics_h
#define signorini_diagnostics_contact_diagnostics_h

#include <signorini/base/archive.h>
#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

namespace signorini
{
  /** Contact at one instant, summed over all contact nodes. */
  struct ContactSummary
  {
    double                normal_force   = 0.; ///< sum of |normal nodal forces|
    double                friction_force = 0.; ///< sum of |tangential nodal forces|
    std::array<double, 3> resultant{}; ///< of the forces on the slave surfaces, friction among them
    unsigned int          n_nodes  = 0;  ///< contact nodes
    unsigned int          n_active = 0;  ///< nodes that carry a contact force
    unsigned int          n_stick  = 0;  ///< of these, with friction
    unsigned int          n_slip   = 0;  ///< of these, with friction
    double                max_slip = 0.; ///< longest way that a node has slid along the other side
    double max_penetration         = 0.; ///< largest violation of u.nu <= g, 0 if there is none
    double geometric_penetration   = 0.; ///< the same by the true geometry, with all obstacles
    std::vector<double> depths;   ///< of each body, see ContactSurface::geometric_penetration()
    std::vector<double> slidings; ///< of each pair, see ContactSurface::largest_sliding()
    double              max_tension        = 0.; ///< largest nodal force of the wrong sign
    double              largest_node_force = 0.; ///< largest |normal nodal force|

    void archive(Archive &archive)
    {
      archive(
        normal_force, friction_force, resultant, n_nodes, n_active, n_stick, n_slip, max_slip);
      archive(max_penetration, geometric_penetration, depths, slidings, max_tension);
      archive(largest_node_force);
    }
  };

  template <int dim>
  ContactSummary contact_summary(const ContactSurface<dim> &surface,
                                 const Discretization<dim> &discretization,
                                 const State               &state);
} // namespace signorini

#endif
