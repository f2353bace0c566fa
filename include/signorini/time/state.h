// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_time_state_h
#define signorini_time_state_h

#include <signorini/base/types.h>

namespace signorini
{
  /** The motion at one instant. The products with M and A are kept, because both the next step and the ledger need them. */
  struct State
  {
    unsigned int step = 0; ///< number of accepted steps
    double       time = 0.;
    Vector       displacement;   ///< u
    Vector       velocity;       ///< v
    Vector       contact_force;  ///< r: nodal forces of contact on the bodies, r.nu <= 0; zero at the start
    Vector       momentum;       ///< M v
    Vector       internal_force; ///< A u
    Vector       acceleration;   ///< a; empty unless the scheme needs it
  };
} // namespace signorini

#endif
