// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_rigid_modes_h
#define signorini_system_rigid_modes_h

#include <signorini/contact/contact_coordinates.h>

namespace signorini
{
  /** A displacement or velocity u of all nodes, and its product with the mass. */
  struct Motion
  {
    Vector displacement; ///< u
    Vector momentum;     ///< M u
  };

  /**
   * The rigid motions of all bodies (translations and infinitesimal rotations of each), orthonormal
   * in the mass matrix. Keeps three vectors for each: 9 per body in 2d, 18 in 3d.
   */
  template <int dim>
  class RigidModes
  {
  public:
    static constexpr unsigned int n_motions = dim * (dim + 1) / 2; ///< of a body

    RigidModes(const Discretization<dim>     &discretization,
               const ContactCoordinates<dim> &coordinates);

    /**
     * An orthonormal basis of the motions that leave some entries at rest: of the rigid motions
     * that nothing holds. Collective.
     * @param entries of contact coordinates, on this process
     */
    std::vector<Motion> free_of(const std::vector<unsigned int> &entries) const;

  private:
    const Discretization<dim> &discretization;
    std::vector<Motion>        modes;
    std::vector<Vector>        local; ///< their displacements in contact coordinates
  };
} // namespace signorini

#endif
