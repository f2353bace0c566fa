// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_types_h
#define signorini_base_types_h

#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

namespace signorini
{
  /** Distributed vector of nodal values; knows its ghost entries and exchanges them. */
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /**
   * Distances gamma = g - u.nu of the contact nodes that this process owns; also bounds for normal
   * increments.
   */
  using NormalGap = std::vector<double>;
} // namespace signorini

#endif
