// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_force_balance_h
#define signorini_adaptivity_force_balance_h

#include <signorini/adaptivity/error_indicator.h>
#include <signorini/discretization/loads.h>

namespace signorini
{
  /**
   * Forces that balance in the finite element space, and what is known of them pointwise:
   *
   * - div sigma(u) + rho q = 0 in the bodies,
   * - sigma(u) n = traction on their surfaces,
   * - r = nodal forces of contact.
   */
  struct ForceBalance
  {
    Vector              displacement;   ///< u, whose stress counts
    Vector              specific_force; ///< q: force per mass, minus the acceleration
    Vector              contact_force;  ///< r
    std::vector<double> gap;            ///< per contact node, where the condition of contact counts
    /** The tractions of the scene are the mean of those at both times. */
    double start_time = 0., end_time = 0.;
  };

  /**
   * The balance that a time step solves. With the trapezoidal rule, whatever the predictor, it is
   * (divided by tau^2/2)
   *
   *   -rho (v_new - v)/tau + div sigma((u + u_new)/2) + rho (f + f_new)/2 = 0,
   *
   * with the contact forces of the step; newmark shares them between the two ends, and
   * backward-euler has everything at the end. Damping takes -rho a (u_new - u)/tau and the stress
   * of (b + b_scheme) (u_new - u)/tau, a and b of the body. The schemes with weights of their own
   * (hht-alpha, generalized-alpha) differ from it by the order of their damping.
   */
  template <int dim>
  ForceBalance balance_of_step(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const StepRecord          &step,
                               const TimeIntegration     &time,
                               BodyForce<dim>            &body_force);

  /** The same for a single step. */
  template <int dim>
  ForceBalance balance_of_step(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const StepRecord          &step,
                               const TimeIntegration     &time);

  /**
   * The balance of a static equilibrium of displacement and nodal contact forces under the loads
   * of a time.
   */
  template <int dim>
  ForceBalance balance_at_rest(const Discretization<dim> &discretization,
                               const ContactSurface<dim> &surface,
                               const Vector              &displacement,
                               const Vector              &contact_force,
                               double                     time = 0.);
} // namespace signorini

#endif
