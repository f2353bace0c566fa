// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_fclib_problem_of_step_h
#define signorini_fclib_problem_of_step_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/fclib/frictional_problem.h>
#include <signorini/time/dynamical_system.h>

namespace signorini
{
  /**
   * The problem of a step and its solution in the form of FCLIB: prescribed entries are eliminated,
   * contact nodes without a bound are left out. The law of friction has to be that of Coulomb,
   * without a cap and for the normal forces of this problem alone. On one process.
   *
   * A contact without friction has mu = 0, and whatever else its node has for tangents. Where
   * friction acts in one direction of two only, the other one has a column of zeros in H.
   *
   * @param coordinates     as they were when it was solved
   * @param obstacle_motion of the step, where slip is relative to obstacles that move; or null
   */
  template <int dim>
  FrictionalProblem problem_of_step(const Discretization<dim>     &discretization,
                                    const ContactCoordinates<dim> &coordinates,
                                    const IncrementProblem        &problem,
                                    const IncrementSolution       &solution,
                                    const Vector                  *obstacle_motion);
} // namespace signorini

#endif
