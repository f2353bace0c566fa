// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_resolution_h
#define signorini_diagnostics_resolution_h

namespace signorini
{
  /** Steps of a contact below which there is hardly more than its ends. */
  constexpr unsigned int few_steps = 8;

  /** Nodes that bear the largest force of a contact below which its size is a matter of chance. */
  constexpr unsigned int few_nodes(const unsigned int dimension)
  {
    return dimension == 3 ? 9 : 4;
  }

  /** Strains from which linear elasticity is visibly wrong. */
  constexpr double large_strain = 0.05;
} // namespace signorini

#endif
