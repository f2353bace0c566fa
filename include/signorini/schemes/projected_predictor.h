// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_projected_predictor_h
#define signorini_schemes_projected_predictor_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /** The free increment tau v and its L2 projection onto the admissible ones. */
  struct ProjectedPredictor
  {
    Vector      increment;       ///< p = tau v + c
    Vector      correction;      ///< c
    Vector      mass_correction; ///< M c
    SolveReport effort;
  };

  /** @param bounds of normal increments; infinite: the projection does not look at the node */
  ProjectedPredictor project_predictor(DynamicalSystem &system,
                                       const State     &state,
                                       double           step_size,
                                       const NormalGap &bounds);

  /**
   * Lift the bounds that a predictor was stopped at in vain: the increment leaves the node open by
   * more than it moves. Such a predictor only followed a velocity that alternates from step to
   * step, and would report a force across a gap. Collective.
   * @param bounds of the projection; infinite afterwards at such nodes
   * @return whether there was one, on any process
   */
  bool lift_bounds_stopped_in_vain(DynamicalSystem          &system,
                                   const ProjectedPredictor &predictor,
                                   const Vector             &increment,
                                   const NormalGap          &gap,
                                   NormalGap                &bounds);

  /** The bounds, infinite at some contact nodes. */
  NormalGap lift_bounds(const NormalGap &all_bounds, const std::vector<bool> &lifted);

  /**
   * If a bound was lifted although the increment does not leave its node open by more than it
   * moves, all of them get their bounds again. Collective.
   * @param all_bounds of the projection, none of them lifted
   * @param lifted before the increment was known; none afterwards in this case
   * @return whether it is
   */
  bool lower_bounds_lifted_in_vain(DynamicalSystem   &system,
                                   const Vector      &increment,
                                   const NormalGap   &gap,
                                   const NormalGap   &all_bounds,
                                   std::vector<bool> &lifted,
                                   NormalGap         &bounds);
} // namespace signorini

#endif
