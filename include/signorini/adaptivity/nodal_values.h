// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_nodal_values_h
#define signorini_adaptivity_nodal_values_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * What belongs to contact nodes, as fields that can be interpolated. Nodal forces depend on the
   * mesh, stresses do not: the stress at a node is the force over the area of the node.
   */

  /** Stress on the slave surfaces (Cartesian) from nodal forces; zero elsewhere. Collective. */
  template <int dim>
  Vector stress_at_nodes(const ContactSurface<dim>     &surface,
                         const ContactCoordinates<dim> &coordinates,
                         Vector                         forces);

  /**
   * Nodal forces of a stress on the slave surfaces, with their opposites on the other bodies.
   * Nothing pulls. Collective.
   */
  template <int dim>
  Vector forces_of_nodes(const ContactSurface<dim>     &surface,
                         const ContactCoordinates<dim> &coordinates,
                         const Vector                  &stress);

  /** Length of the way of slip in the first component, a mark of the status in the second. */
  template <int dim>
  Vector path_and_status(const ContactSurface<dim> &surface, const FrictionState &friction);

  /**
   * The inverse. A node between others has the status that all of them share, otherwise it is
   * open.
   */
  template <int dim>
  void set_path_and_status(const ContactSurface<dim> &surface,
                           const Vector              &values,
                           FrictionState             &friction);
} // namespace signorini

#endif
