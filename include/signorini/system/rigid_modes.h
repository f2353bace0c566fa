// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_rigid_modes_h
#define signorini_system_rigid_modes_h

#include <signorini/contact/contact_coordinates.h>

namespace signorini
{
  /**
   * The rigid motions of all bodies (translations and infinitesimal rotations of each), orthonormal in the mass matrix. Keeps as many
   * vectors: 3 per body in 2d, 6 in 3d.
   */
  template <int dim>
  class RigidModes
  {
  public:
    explicit RigidModes(const Discretization<dim> &discretization);

    /**
     * An orthonormal basis of the motions that leave some entries at rest: of the rigid motions that nothing holds.
     * @param entries of contact coordinates, on this process
     * Collective.
     */
    std::vector<Vector> free_of(const ContactCoordinates<dim>   &coordinates,
                                const std::vector<unsigned int> &entries) const;

  private:
    const Discretization<dim> &discretization;
    std::vector<Vector>        modes;
  };
} // namespace signorini

#endif
