// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_motion_energies_h
#define signorini_system_motion_energies_h

#include <algorithm>

namespace signorini
{
  /** The largest energies that a motion has had, which errors of its steps are compared with. */
  struct MotionEnergies
  {
    double motion  = 0.; ///< kinetic and elastic together
    double elastic = 0.;

    /** The motion has, or had, these as well. */
    void add(const MotionEnergies &further)
    {
      motion  = std::max(motion, further.motion);
      elastic = std::max(elastic, further.elastic);
    }

    /**
     * The energy that errors of a step are to be small against. Where bodies hardly deform, an
     * error that is small against their motion is none in the ledger, and much in stresses and
     * contact forces: they are to have 1/50 of the relative accuracy that the motion has. But no
     * error needs to be less than 1/50 of what the motion accepts: a body that flies has no
     * stresses, but for round-off. Impacts, whose energy is elastic for some time, are not
     * concerned.
     */
    double scale() const { return std::clamp(2500. * elastic, motion / 2500., motion); }
  };
} // namespace signorini

#endif
