// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_friction_reading_h
#define signorini_diagnostics_friction_reading_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Friction at one contact node, to be shown to people: slips are lengths by which the surfaces
   * have moved along each other, that is, entries of the state over the transmission of the node
   * (like ContactSurface::distance()).
   */
  template <int dim>
  struct FrictionReading
  {
    dealii::Tensor<1, dim> force; ///< tangential nodal force on the slave
    dealii::Tensor<1, dim> slip;  ///< of the slave relative to the other side, in the last step
    dealii::Tensor<1, dim> accumulated_slip; ///< since the start, with its direction
    double                 slip_path = 0.;   ///< length of the way since the start
    char                   status    = contact_status::open;
  };

  /**
   * All zero and open while the state knows no friction. @param k index into
   * ContactSurface::nodes()
   */
  template <int dim>
  FrictionReading<dim>
  friction_at(const ContactSurface<dim> &surface, const FrictionState &friction, unsigned int k);

  /** Friction whose forces are own_forces(), with all else as it is. Collective. */
  template <int dim>
  FrictionState own_friction(const ContactSurface<dim> &surface, const FrictionState &friction);
} // namespace signorini

#endif
