// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_rayleigh_damping_h
#define signorini_base_rayleigh_damping_h

namespace signorini
{
  /** Viscous damping of a body, C = mass M + stiffness A. */
  struct RayleighDamping
  {
    double mass      = 0.; ///< per time, >= 0
    double stiffness = 0.; ///< a time, >= 0

    bool any() const { return mass > 0. || stiffness > 0.; }
  };
} // namespace signorini

#endif
