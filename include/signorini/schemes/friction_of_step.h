// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_friction_of_step_h
#define signorini_schemes_friction_of_step_h

#include <signorini/time/dynamical_system.h>
#include <signorini/time/state.h>

namespace signorini
{
  /** What friction did in a step. */
  struct FrictionOfStep
  {
    FrictionState state;     ///< at the end of the step; empty without friction
    double        work = 0.; ///< of its force on the slip
  };

  /**
   * The friction of a step that was solved.
   * @param before        at its start
   * @param factor        forces per reaction
   * @param contact_force the force of friction is added to it
   */
  FrictionOfStep friction_of_step(const FrictionState     &before,
                                  const IncrementSolution &solution,
                                  double                   factor,
                                  Vector                  &contact_force);

  /** What moving obstacles do by the friction of a step, whose own work is that on the slip. */
  inline double work_of_obstacles_by_friction(DynamicalSystem     &system,
                                              const FrictionState &friction)
  {
    return friction.any() ? obstacle_work(system, friction.force) : 0.;
  }
} // namespace signorini

#endif
