// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_record_friction_h
#define signorini_schemes_record_friction_h

#include <signorini/time/dynamical_system.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Add the friction of a step to the contact force r, and let the state remember it with the slip. Without friction
   * nothing happens.
   * @param factor forces per reaction
   * @return the work of this friction on the increment
   */
  double record_friction(State &state, const IncrementSolution &solution, double factor, Vector &contact_force);
} // namespace signorini

#endif
