// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_sum_of_magnitudes_h
#define signorini_base_sum_of_magnitudes_h

#include <signorini/base/types.h>

namespace signorini
{
  /**
   * The magnitudes of the vectors at all nodes, added up over all processes: the same in any frame,
   * which the sum of the components is not.
   * @param n_components of a node, which follow each other
   */
  double sum_of_magnitudes(const Vector &vector, unsigned int n_components);
} // namespace signorini

#endif
