// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_mass_change_h
#define signorini_discretization_mass_change_h

#include <signorini/linear_algebra/elastic_matrices.h>

#include <map>

namespace signorini
{
  /**
   * What is added to entries of the mass: (global row node, global column node) -> change. Both
   * triangles.
   */
  using MassChange =
    std::map<std::pair<dealii::types::global_dof_index, dealii::types::global_dof_index>, double>;
} // namespace signorini

#endif
