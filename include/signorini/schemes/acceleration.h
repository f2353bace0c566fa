// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_acceleration_h
#define signorini_schemes_acceleration_h

#include <signorini/time/dynamical_system.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * The acceleration of a state; of the first one, which has none yet,
   * @f$M^{-1} (f - A u + r)@f$, where @f$r@f$ is zero unless the run starts in equilibrium.
   * @param by_contact false: without @f$r@f$, for schemes in which contact forces are impulses and
   *                   no part of the acceleration
   */
  inline Vector
  acceleration_of(DynamicalSystem &system, const State &state, const bool by_contact = true)
  {
    if (state.acceleration.size() > 0)
      return state.acceleration;
    Vector force = system.make_vector();
    system.add_load(force, 1., state.time);
    force -= state.internal_force;
    if (by_contact)
      force += state.contact_force;
    return system.solve_mass(force);
  }
} // namespace signorini

#endif
