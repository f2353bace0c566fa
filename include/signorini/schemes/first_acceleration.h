// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_first_acceleration_h
#define signorini_schemes_first_acceleration_h

#include <signorini/time/dynamical_system.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * The acceleration @f$M^{-1} (f - A u + r)@f$ of a state that has none yet; @f$r@f$ is zero
   * unless the run starts in equilibrium.
   * @param by_contact false: without @f$r@f$, for schemes in which contact forces are impulses and
   *                   no part of the acceleration
   */
  inline Vector
  first_acceleration(DynamicalSystem &system, const State &state, const bool by_contact = true)
  {
    Vector force = system.make_vector();
    system.add_load(force, 1., state.time);
    force -= state.internal_force;
    if (by_contact)
      force += state.contact_force;
    return system.solve_mass(force);
  }
} // namespace signorini

#endif
