// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_element_warnings_h
#define signorini_simulation_element_warnings_h

#include <signorini/discretization/mesh.h>

#include <string>
#include <vector>

namespace signorini
{
  /**
   * What is too stiff or too soft because of the choice of the element: bodies that lock near
   * incompressibility, and bodies of one or two cells in their thickness that are at least five
   * times as long, where bending matters. A sentence each. Collective.
   */
  template <int dim>
  std::vector<std::string> element_warnings(const Mesh<dim> &mesh);
} // namespace signorini

#endif
