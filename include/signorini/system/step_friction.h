// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_step_friction_h
#define signorini_system_step_friction_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/time/dynamical_system.h>
#include <signorini/variational_inequality/frictional_contact.h>

namespace signorini
{
  /**
   * Between the friction of contact nodes and the problem of a step: laws in the scale of its
   * matrix, forces and slip from its solution.
   */
  template <int dim>
  class StepFriction
  {
  public:
    /** Collective. @param may_come whether nodes without friction may get some */
    StepFriction(const ContactCoordinates<dim> &coordinates, bool may_come, MPI_Comm communicator);

    /** Whether any contact node of any process has friction. */
    bool any() const { return has_friction; }

    /**
     * The friction of the bounded entries of a step. Tresca's friction acts at nodes that touch
     * when the step begins.
     * @param factor   reactions per nodal force
     * @param bounds   of the step
     * @param touching distance below which a node touches
     * @param further_reaction  see IncrementProblem; null: none
     */
    Friction of_step(double           factor,
                     const NormalGap &bounds,
                     double           touching,
                     const Vector    *further_reaction) const;

    /** What tells the forces of nodes that slip. */
    enum class SlipForces
    {
      of_law,     ///< along the slip, as large as the law says
      of_residual ///< where the solution has lost the motion in which they slip
    };

    /**
     * The friction in a solution.
     * @param status    of the solver
     * @param increment, residual in contact coordinates
     * @param matrix    of the problem
     * @param pressed_from_elsewhere whether the laws contain a further reaction; an open node that
     *                               it entitles to friction is reported as closed
     * @param solution  gets friction_reaction (in contact coordinates), friction_work, slip
     *                  (Cartesian), slip_length, and status (open, slip or stick)
     */
    void extract(const Friction       &friction,
                 const ActiveSet      &status,
                 const Vector         &increment,
                 const Vector         &residual,
                 const LinearOperator &matrix,
                 bool                  pressed_from_elsewhere,
                 IncrementSolution    &solution,
                 SlipForces            slip_forces = SlipForces::of_law) const;

  private:
    const ContactCoordinates<dim> &coordinates;
    bool                           has_friction;
  };
} // namespace signorini

#endif
