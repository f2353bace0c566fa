// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_rigid_springs_h
#define signorini_system_rigid_springs_h

#include <signorini/linear_algebra/linear_operator.h>
#include <signorini/system/rigid_modes.h>

namespace signorini
{
  /**
   * The stiffness with springs at the rigid motions of the bodies, in contact coordinates,
   *
   *   K = A + R S R',   R = M Z,
   *
   * with the rigid motions Z, orthonormal in M: R'x are the amplitudes of the rigid motions in x.
   * Elastic deformations without rigid part do not feel the springs. Where S is zero they cost
   * nothing.
   */
  template <int dim>
  class RigidSprings : public LinearOperator
  {
  public:
    RigidSprings(const LinearOperator &stiffness, const RigidModes<dim> &rigid);

    /** @param stiffness_of_springs S, symmetric and semidefinite, in the order of the modes */
    void set(const Eigen::MatrixXd &stiffness_of_springs);

    void vmult(Vector &destination, const Vector &source) const override;
    void diagonal(Vector &destination) const override;

    /** R'x. Collective. */
    Eigen::VectorXd amplitudes(const Vector &displacement) const;

    /** force += R times forces on the rigid motions. */
    void add_forces(const Eigen::VectorXd &forces, Vector &force) const;

  private:
    const LinearOperator     &stiffness;
    const std::vector<Vector> momenta; ///< R
    Eigen::MatrixXd           springs; ///< S
    bool                      any = false;
  };
} // namespace signorini

#endif
