// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_own_forces_h
#define signorini_contact_own_forces_h

#include <signorini/contact/contact_surface.h>

namespace signorini
{
  /**
   * Nodal forces of contact without what other contact nodes hand on to their partners: at a
   * contact node those that hold it itself. Partners may be contact nodes where contact follows the
   * motion; otherwise these are the forces as they are, at contact nodes. Collective.
   */
  template <int dim>
  Vector own_forces(const ContactSurface<dim> &surface, const Vector &forces);
} // namespace signorini

#endif
