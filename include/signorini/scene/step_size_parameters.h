// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_scene_step_size_parameters_h
#define signorini_scene_step_size_parameters_h

#include <signorini/base/enum_names.h>

namespace signorini
{
  /** How long steps are. */
  enum class StepSizeControl
  {
    fixed,
    doubling,
    embedded,
    force,
    goal
  };

  template <>
  struct EnumNames<StepSizeControl>
  {
    static constexpr EnumName<StepSizeControl> table[] = {{StepSizeControl::fixed, "fixed"},
                                                          {StepSizeControl::doubling, "doubling"},
                                                          {StepSizeControl::embedded, "embedded"},
                                                          {StepSizeControl::force, "force"},
                                                          {StepSizeControl::goal, "goal"}};
  };

  /**
   * Keys of section `Time`: how the size of steps follows the motion. Step size and end time are
   * in TimeParameters.
   */
  struct StepSizeParameters
  {
    StepSizeControl control = StepSizeControl::fixed; ///< see doc/step_size.md

    double tolerance = 1e-2; ///< accepted error of a step, relative to the norm of the motion, or
                             ///< to the largest force; of a goal: its target
    double minimum = 0.;     ///< zero: half the time of a wave through the smallest cell
    double maximum = 0.;     ///< zero: a tenth of the end time

    bool is_variable() const { return control != StepSizeControl::fixed; }
  };
} // namespace signorini

#endif
