// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_body_motion_h
#define signorini_diagnostics_body_motion_h

#include <signorini/discretization/discretization.h>
#include <signorini/time/state.h>

#include <numeric>

namespace signorini
{
  /** One body at one instant. Energies and momenta are those of the mass of the scheme. */
  struct BodyReading
  {
    double                kinetic_energy = 0., elastic_energy = 0.;
    std::array<double, 3> momentum{};
    /**
     * About the centroid: int rho (X - X_c) x v with positions of the reference configuration, of
     * which linear elasticity conserves every component.
     */
    std::array<double, 3> angular_momentum{};
    std::array<double, 3> centroid{}; ///< where the centre of mass is now
    std::array<double, 3> velocity{}; ///< mean: momentum over mass
  };

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

    /**
     * Of forces about the centre of mass of each body: at the places of their nodes in the
     * reference configuration or, with a displacement, what it adds to that by taking the places
     * with it. Collective.
     */
    std::vector<double> moments(const Vector &forces, const Vector *displacement = nullptr) const;

    /**
     * u'Au/2 of all bodies, u without what carries and turns each of them as a whole: however far
     * they have gone, the round-off of forces there works nothing. Cells with curved edges are
     * strained by the nodal values of a rotation: there only translations are taken out.
     * Collective.
     */
    double elastic_energy(const State &state) const;

    /** Each body at one instant, the same on all processes. Collective. */
    std::vector<BodyReading> read(const State &state) const;

    const std::vector<double> &masses_of_bodies() const { return masses; }

    /** Of all bodies. */
    double mass() const { return std::accumulate(masses.begin(), masses.end(), 0.); }

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
    bool                                   turns_without_strain; ///< see elastic_energy()
    std::vector<MassPoint>                 points;
    std::vector<double>                    masses;  ///< of each body
    std::vector<dealii::Tensor<1, dim>>    centres; ///< of mass, in the reference configuration
    std::vector<dealii::Tensor<2, n_axes>> inverse_inertia; ///< of each body

    /** arm x vector. */
    static Moment moment(const dealii::Tensor<1, dim> &arm, const dealii::Tensor<1, dim> &vector);
  };
} // namespace signorini

#endif
