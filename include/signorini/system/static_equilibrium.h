// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_static_equilibrium_h
#define signorini_system_static_equilibrium_h

#include <signorini/discretization/loads.h>
#include <signorini/model/run_parameters.h>
#include <signorini/system/rigid_modes.h>
#include <signorini/system/step_friction.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * The equilibrium of a scene under its loads and contact at time 0,
   *
   *   A u + M a = f + r,   u.nu <= g, r and friction as ever,
   *
   * where a is the acceleration of the rigid motions that nothing holds (prescribed nodes,
   * closed nodes, sticking nodes), and u has no part in them. A block that slides on a plane thus
   * starts with the shear that decelerates it, and a body in free fall without deformation. The
   * slip of friction is the relative tangential displacement from the undeformed bodies or, where
   * the initial velocity has one, along its tangential part.
   *
   * Found by proximal steps: u_new is the equilibrium with the additional term sigma M (u_new - u),
   * which makes the problem definite, and a takes what drives the free motions. With sigma small
   * compared with the lowest eigenvalue of the bodies a few steps do.
   */
  template <int dim>
  class StaticEquilibrium
  {
  public:
    StaticEquilibrium(const Discretization<dim>     &discretization,
                      const ContactSurface<dim>     &surface,
                      const ContactCoordinates<dim> &coordinates,
                      const SolverParameters        &parameters);

    /**
     * Put displacement, contact force and friction of the state to the equilibrium; the velocity is
     * only read. Collective.
     * @return number of proximal steps
     * @throws RunError if no equilibrium is found
     */
    unsigned int find(State &state, const Vector *load);

  private:
    const Discretization<dim>     &discretization;
    const ContactSurface<dim>     &surface;
    const ContactCoordinates<dim> &coordinates;
    const SolverParameters         parameters;
    const StepFriction<dim>        friction;

    /** The law of each contact node; its past slip points along the initial velocity. */
    Friction friction_of_nodes(const NormalGap &gap, const Vector &velocity) const;
    void     set_forces(State           &state,
                        const Friction  &laws,
                        const ActiveSet &status,
                        const Vector    &increment,
                        const Vector    &residual) const;
  };
} // namespace signorini

#endif
