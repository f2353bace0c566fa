// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mass_redistribute_mass_h
#define signorini_mass_redistribute_mass_h

#include <signorini/contact/contact_surface.h>
#include <signorini/model/mass_parameters.h>

namespace signorini
{
  /**
   * Give the time discretisation the mass that is asked for, if that has no entries at contact
   * nodes (redistributed, or zero on contact boundary). The consistent mass stays in
   * matrices().standard_mass. With two bodies the nodes of the slave lose their mass, to others of
   * the same body. Vectors made before are of no use afterwards.
   *
   * Collective.
   * @return a sentence about the mass for the user, empty if nothing was changed
   * @throws UserError if there are no contact nodes, too few nodes behind them, or the result is
   * not positive definite
   */
  template <int dim>
  std::string redistribute_mass(Discretization<dim>       &discretization,
                                const ContactSurface<dim> &surface,
                                const MassParameters      &mass);
} // namespace signorini

#endif
