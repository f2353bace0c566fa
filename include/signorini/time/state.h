// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_state_h
#define signorini_time_state_h

#include <signorini/base/contact_status.h>
#include <signorini/base/types.h>

#include <utility>

namespace signorini
{
  /** Friction at the end of a step and what it has done so far. Empty without friction. */
  struct FrictionState
  {
    Vector force; ///< the tangential part of the contact force
    Vector slip;  ///< of the last step: relative tangential increments of closed contact nodes
    Vector accumulated_slip;       ///< sum of these increments since the start
    std::vector<double> slip_path; ///< sum of their lengths, per contact node of this process
    ActiveSet           status;    ///< of the last step, per contact node of this process

    bool any() const { return force.size() > 0; }
  };

  /**
   * What the last step did to the motion: the control of steps compares with it. Empty where
   * nobody asks for it.
   */
  struct LastStep
  {
    double size = 0.;
    Vector velocity_change;
    Vector momentum_change; ///< M times the change of velocity

    bool any() const { return size > 0.; }
  };

  /**
   * The motion at one instant: all that goes from step to step and from mesh to mesh. With the mesh
   * and its `Refinements` it determines how a run goes on; what solvers and the control of steps
   * remember besides may be forgotten (see TimeStepping::forget()). The products with M and A are
   * kept, because both the next step and the ledger need them.
   */
  struct State
  {
    unsigned int step = 0; ///< number of accepted steps
    double       time = 0.;
    Vector       displacement; ///< u
    Vector       velocity;     ///< v
    Vector contact_force;      ///< r: nodal forces of contact and friction on the bodies, r.nu <= 0
    Vector momentum;           ///< M v
    Vector internal_force;     ///< A u
    Vector acceleration;       ///< a; empty unless the scheme needs it
    FrictionState friction;
    LastStep      last_step;
  };

  /** Exchange two states without a copy of any vector. */
  inline void swap(State &a, State &b)
  {
    std::swap(a.step, b.step);
    std::swap(a.time, b.time);
    for (const auto member : {&State::displacement,
                              &State::velocity,
                              &State::contact_force,
                              &State::momentum,
                              &State::internal_force,
                              &State::acceleration})
      (a.*member).swap(b.*member);
    for (const auto member :
         {&FrictionState::force, &FrictionState::slip, &FrictionState::accumulated_slip})
      (a.friction.*member).swap(b.friction.*member);
    a.friction.slip_path.swap(b.friction.slip_path);
    a.friction.status.swap(b.friction.status);
    std::swap(a.last_step.size, b.last_step.size);
    a.last_step.velocity_change.swap(b.last_step.velocity_change);
    a.last_step.momentum_change.swap(b.last_step.momentum_change);
  }
} // namespace signorini

#endif
