// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_separate_parts_h
#define signorini_linear_algebra_separate_parts_h

#include <signorini/linear_algebra/node_pattern.h>

namespace signorini
{
  /** Parts of a matrix that nothing couples: bodies that meet no other one. */
  struct SeparateParts
  {
    /** More parts than this count as one. */
    static constexpr unsigned int most = 32;

    unsigned int              n = 1;
    std::vector<unsigned int> part_of; ///< per owned node; 0 for one that is coupled with none

    /** Collective. */
    template <int dim>
    static SeparateParts of(const NodePattern &pattern);
  };
} // namespace signorini

#endif
