// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_adaptivity_parameters_h
#define signorini_model_adaptivity_parameters_h

#include <string>

namespace signorini
{
  /** Section `Adaptivity`: how the mesh follows the motion. Levels count refinements of the coarse mesh, as `Refinements` of a body does. */
  struct AdaptivityParameters
  {
    std::string  indicator        = "none";           ///< none | residual | kelly | distance
    std::string  marking          = "fixed fraction"; ///< fixed fraction | tolerance; of no use with distance
    double       refine_fraction  = 0.5;              ///< of the squared estimate, fixed fraction
    double       coarsen_fraction = 0.02;             ///< of the squared estimate, fixed fraction
    double       coarsen_ratio    = 0.;  ///< of thresholds for squared indicators; 0: what smooth solutions allow
    double       tolerance        = 0.;  ///< root of an energy; below, nothing is refined. 0: none
    double       hysteresis       = 0.1; ///< part of the squared estimate or of the cells that is worth a change
    unsigned int maximum_level    = 0;   ///< cells of this level are not refined
    unsigned int minimum_level    = 0;   ///< cells of this level are not coarsened, nor those of the initial mesh
    unsigned int maximum_cells    = 0;   ///< about; 0: no limit
    unsigned int steps_between    = 1;   ///< the mesh may change after every so many steps
    unsigned int repetitions      = 0;   ///< of a step on a refined mesh, before it is accepted
    double       distance = 0.; ///< of distance; 0: three times the size of each cell. Of others: see refines_contact()

    /** Whether the mesh may change at all. */
    bool any() const { return indicator != "none"; }

    /** Whether cells closer to contact than `distance` are refined whatever the estimate of an error says. */
    bool refines_contact() const { return any() && indicator != "distance" && distance > 0.; }
  };
} // namespace signorini

#endif
