// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_energy_of_vibration_h
#define signorini_adaptivity_energy_of_vibration_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Take energy out of the vibration of the bodies: with @f$w@f$, the part of the velocity
   * @f$v@f$ that is M-orthogonal to the rigid motions of free bodies and zero at Dirichlet
   * conditions,
   * @f[
   *   v \leftarrow v - t w, \quad
   *   \tfrac12 v^T M v - \tfrac12 (v - t w)^T M (v - t w) = \text{energy}.
   * @f]
   * Linear and angular momentum of free bodies, displacements and gaps stay what they are. If there
   * is less than that in the vibration, all of it is taken. Collective.
   * @param energy > 0
   * @param state  complete; its velocity and momentum are changed
   */
  template <int dim>
  void take_from_vibration(const Discretization<dim>     &discretization,
                           const ContactCoordinates<dim> &coordinates,
                           double                         energy,
                           State                         &state);
} // namespace signorini

#endif
