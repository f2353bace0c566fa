// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_friction_excess_h
#define signorini_diagnostics_friction_excess_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * By how much the tangential force of any contact node exceeds its bound at most: a nodal force,
   * negative or zero if the law of friction is kept. Nodes that several obstacles hold are left
   * out: their bound is that of several laws. Collective.
   */
  template <int dim>
  double friction_excess(const ContactSurface<dim> &surface, const State &state, MPI_Comm);
} // namespace signorini

#endif
