// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_contact_fields_h
#define signorini_adaptivity_contact_fields_h

#include <signorini/adaptivity/force_balance.h>
#include <signorini/adaptivity/surface_roles.h>
#include <signorini/finite_elements/stress_vectors.h>

namespace signorini
{
  /**
   * Nodal fields that describe contact on the surfaces, with ghosts and values at hanging nodes;
   * zero away from contact.
   */
  template <int dim>
  struct ContactFields
  {
    Vector normal;   ///< nu at contact nodes
    Vector traction; ///< what acts on the body: of friction at contact nodes; all of it, opposite
                     ///< to the slave's, at master nodes
    Vector open;     ///< first component: 1 at nodes of slave surfaces that are not in full contact
    Vector pressure; ///< first component: s = -r_nu / D at contact nodes
    Vector gap;      ///< first component: >= 0, at contact nodes that are not closed
  };

  /** @param stress of the displacement of the balance */
  template <int dim>
  ContactFields<dim> contact_fields(const StressVectors<dim>       &stress,
                                    const SurfaceRoles<dim>        &roles,
                                    const ContactSurface<dim>      &surface,
                                    const DirichletConditions<dim> &dirichlet,
                                    const ForceBalance             &balance);

  /** @param displacement with ghosts and values at hanging nodes */
  template <int dim>
  ContactFields<dim> contact_fields(const Discretization<dim>      &discretization,
                                    const ContactSurface<dim>      &surface,
                                    const DirichletConditions<dim> &dirichlet,
                                    const ForceBalance             &balance,
                                    const Vector                   &displacement)
  {
    const CellNeighbors<dim> mesh(discretization);
    return contact_fields(StressVectors<dim>(mesh, displacement),
                          SurfaceRoles<dim>(mesh, surface),
                          surface,
                          dirichlet,
                          balance);
  }

  /**
   * Whether contact presses on a node: its normal force is compression, and more than the
   * round-off of the largest nodal force.
   */
  template <int dim>
  std::vector<bool> closed_nodes(const ContactSurface<dim> &surface, const Vector &contact_force);
} // namespace signorini

#endif
