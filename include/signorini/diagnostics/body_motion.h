// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_body_motion_h
#define signorini_diagnostics_body_motion_h

#include <signorini/discretization/discretization.h>

namespace signorini
{
  /**
   * How each body has moved as a whole: means of the nodal displacements, weighted with the lumped
   * mass. Of linear elasticity only what turns little is to be believed, so that the rotation is
   * the vector of the infinitesimal one.
   */
  template <int dim>
  class BodyMotion
  {
  public:
    /** Collective. */
    explicit BodyMotion(const Discretization<dim> &discretization);

    /**
     * Angle of the mean rotation of each body about its centre of mass, in radians, the same on
     * all processes. Collective.
     */
    std::vector<double> rotation(const Vector &displacement) const;

  private:
    static constexpr unsigned int n_axes = dim == 2 ? 1 : 3;
    using Moment                         = dealii::Tensor<1, n_axes>;

    /** An owned node with its share of the body. */
    struct MassPoint
    {
      unsigned int           node, body;
      double                 mass;
      dealii::Tensor<1, dim> arm; ///< from the centre of mass
    };

    MPI_Comm                               communicator;
    std::vector<MassPoint>                 points;
    std::vector<dealii::Tensor<2, n_axes>> inverse_inertia; ///< of each body

    /** arm x vector. */
    static Moment moment(const dealii::Tensor<1, dim> &arm, const dealii::Tensor<1, dim> &vector);
  };
} // namespace signorini

#endif
