// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_largest_strains_h
#define signorini_finite_elements_largest_strains_h

#include <signorini/discretization/discretization.h>

namespace signorini
{
  /**
   * For each body the largest principal strain, in size, in the middle of any of its cells; the
   * same on all processes. Collective.
   */
  template <int dim>
  std::vector<double> largest_strains(const Discretization<dim> &discretization,
                                      const Vector              &displacement);
} // namespace signorini

#endif
