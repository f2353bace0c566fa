// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_rigid_modes_h
#define signorini_system_rigid_modes_h

#include <signorini/contact/contact_coordinates.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <array>

namespace signorini
{
  /** A displacement or velocity u of all nodes, and its product with the mass. */
  struct Motion
  {
    Vector displacement; ///< u
    Vector momentum;     ///< M u
  };

  /** A direction in the plane of two entries of a node, of length 1. */
  struct HeldDirection
  {
    std::array<unsigned int, 2> entries;
    std::array<double, 2>       parts;
  };

  /**
   * The rigid motions (translations and infinitesimal rotations) of all bodies that Dirichlet
   * conditions do not hold altogether, orthonormal in the mass matrix. Keeps three vectors for
   * each: 9 per body in 2d, 18 in 3d.
   */
  template <int dim>
  class RigidModes
  {
  public:
    static constexpr unsigned int n_motions = dim * (dim + 1) / 2; ///< of a body

    /** Collective. */
    RigidModes(const Discretization<dim>     &discretization,
               const ContactCoordinates<dim> &coordinates);

    /** The bodies that can move, ascending. */
    const std::vector<unsigned int> &bodies() const { return loose_bodies; }

    /** Number of motions: those of the first of these bodies, then those of the next. */
    unsigned int size() const { return modes.size(); }

    /** The momenta M u of all motions as generalised forces in contact coordinates, T'M u. */
    std::vector<Vector> momenta_in_contact() const;

    /** Add motions with amplitudes to a displacement in contact coordinates. */
    void add_in_contact(const Eigen::VectorXd &amplitudes, Vector &displacement) const;

    /** Sum of the absolute values of the products of each motion with forces >= 0. Collective. */
    Eigen::VectorXd sizes_of_products(const Vector &forces) const;

    /** The angular velocity of a motion as a vector; in 2d about the third axis. */
    const dealii::Tensor<1, 3> &rotation(const unsigned int which) const
    {
      return rotations[which];
    }

    /**
     * An orthonormal basis of the motions that leave some entries at rest, by amplitudes, a column
     * each: of the rigid motions that nothing holds. Collective.
     * @param entries    of contact coordinates, on this process
     * @param directions in which other nodes are at rest
     */
    Eigen::MatrixXd free_amplitudes(const std::vector<unsigned int>  &entries,
                                    const std::vector<HeldDirection> &directions = {}) const;

    /** The same as motions. */
    std::vector<Motion> free_of(const std::vector<unsigned int> &entries) const;

  private:
    const Discretization<dim>        &discretization;
    const ContactCoordinates<dim>    &coordinates;
    std::vector<unsigned int>         loose_bodies;
    std::vector<Motion>               modes;
    std::vector<Vector>               local; ///< their displacements in contact coordinates
    std::vector<double>               sizes; ///< their largest displacements
    std::vector<dealii::Tensor<1, 3>> rotations;
  };
} // namespace signorini

#endif
