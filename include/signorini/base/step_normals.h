// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_step_normals_h
#define signorini_base_step_normals_h

namespace signorini
{
  /** Which normals contact that follows the motion has in a step. */
  enum class StepNormals
  {
    of_motion, ///< discrete gradients, with which contact forces do the work of the energy laws
    at_end     ///< of the place where the step ends, as the forces of an equilibrium have them
  };
} // namespace signorini

#endif
