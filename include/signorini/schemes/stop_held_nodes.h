// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_stop_held_nodes_h
#define signorini_schemes_stop_held_nodes_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * The nodes that touched before a step and are held at its end, which have no reason to move on.
   * @param normal     whether they shall lose their normal velocity
   * @param tangential whether those that stick shall lose their tangential velocity
   */
  ActiveSet staying_nodes(const DynamicalSystem   &system,
                          const NormalGap         &gap,
                          const IncrementSolution &solution,
                          bool                     normal,
                          bool                     tangential);

  /**
   * End a step with the velocity that is closest in M and without relative motion at some nodes,
   * see MassProjections::stop_relative_motion(). It can only take kinetic energy. Nodes that
   * contact would have to pull for that are let go. In a trial nothing is done.
   * @param held            the nodes
   * @param velocity        at the start of the step
   * @param velocity_change of the step, corrected
   * @param contact_force   gets the impulses over the step size
   * @param report          gets the effort (with the predictor), and the work at prescribed nodes
   *                        and of obstacles
   * @return the change of energy, <= 0
   */
  double stop_held_nodes(DynamicalSystem &system,
                         ActiveSet        held,
                         double           step_size,
                         const Vector    &velocity,
                         Vector          &velocity_change,
                         Vector          &contact_force,
                         StepReport      &report);
} // namespace signorini

#endif
