// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_exact_solution_h
#define signorini_model_exact_solution_h

#include <array>
#include <string>

namespace signorini
{
  /**
   * Section `Exact solution`: expressions in x, y, z, t, per component; empty displacement: none
   * given.
   */
  template <int dim>
  struct ExactSolutionDescription
  {
    bool                         given = false;
    std::array<std::string, dim> displacement;
    std::array<std::string, dim> velocity;
  };
} // namespace signorini

#endif
