// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_counted_nodes_h
#define signorini_diagnostics_counted_nodes_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Normal nodal forces up to this are round-off, and their nodes are not counted as active; see
   * unnoticed_force. Collective.
   * @param own forces of the nodes, see own_forces()
   */
  template <int dim>
  double force_of_round_off(const ContactSurface<dim> &surface,
                            const Discretization<dim> &discretization,
                            const State               &state,
                            const Vector              &own);
} // namespace signorini

#endif
