// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_rigid_flight_h
#define signorini_diagnostics_rigid_flight_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * How bodies move that nothing touches: @f$u(t) = u_0 + t v_0 + \frac{t^2}{2} a@f$ with the mean
   * acceleration of each body by its loads at the start. What is held by conditions, or touches
   * something, does not fall. Deformation on the way is left out, and so is rotation beyond the
   * velocities of the start.
   */
  template <int dim>
  class RigidFlight
  {
  public:
    /**
     * Collective.
     * @param start must outlive the object
     * @param load   nodal forces at the start; null: none
     * @param masses of the bodies
     * @param falls  of each body, whether its loads accelerate it
     */
    RigidFlight(const Discretization<dim> &discretization,
                const State               &start,
                const Vector              *load,
                const std::vector<double> &masses,
                const std::vector<bool>   &falls);

    /** After a time since the start. */
    Vector displacement(double time) const;
    Vector velocity(double time) const;

    /** The longest way of any node of a body between two times: an upper bound. */
    double way(unsigned int body, double begin, double end) const;

  private:
    const State        &start;
    Vector              acceleration;
    std::vector<double> speeds, accelerations; ///< the largest of each body, on all processes
  };


  /** Each pair's smallest distance in a configuration, no farther than a reach. Collective. */
  template <int dim>
  std::vector<double> distances_of_pairs(const ContactSurface<dim> &surface,
                                         const Vector              &displacement,
                                         double                     reach,
                                         MPI_Comm                   communicator);


  /**
   * For each pair the time from the start until its sides are about to touch, by the true geometry;
   * infinite if they do not before `duration`, or if a side meets something else before. Steps are
   * as long as distance and speeds allow, so that nothing is passed; but at least a 200th of the
   * duration: what touches for a shorter time may be missed. Where obstacles move, all steps have
   * this length. The obstacles are where they are at the start when this returns. Collective.
   * @param start_time of the obstacles
   */
  template <int dim>
  std::vector<double> times_of_meeting(ContactSurface<dim>       &surface,
                                       const Discretization<dim> &discretization,
                                       const RigidFlight<dim>    &flight,
                                       double                     start_time,
                                       double                     duration,
                                       bool                       obstacles_move);
} // namespace signorini

#endif
