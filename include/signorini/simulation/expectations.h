// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_expectations_h
#define signorini_simulation_expectations_h

#include <signorini/simulation/first_impacts.h>
#include <signorini/simulation/initial_state.h>

namespace signorini
{
  /**
   * What the first impact of each pair is going to be like by simple theories, and whether mesh and
   * steps can carry it: a sentence each.
   */
  template <int dim>
  Remarks expectations(const Scene<dim> &scene, const std::vector<FirstImpact> &impacts);
} // namespace signorini

#endif
