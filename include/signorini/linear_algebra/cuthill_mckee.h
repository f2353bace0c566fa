// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_cuthill_mckee_h
#define signorini_linear_algebra_cuthill_mckee_h

#include <signorini/linear_algebra/node_pattern.h>

namespace signorini
{
  /**
   * The local nodes in the order of Cuthill and McKee (not reversed): given ones, what is connected
   * with them level by level, and every other connected part from a peripheral node.
   */
  std::vector<unsigned int> cuthill_mckee(const NodePattern               &pattern,
                                          const std::vector<unsigned int> &first = {});
} // namespace signorini

#endif
