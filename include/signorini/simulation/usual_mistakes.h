// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_usual_mistakes_h
#define signorini_simulation_usual_mistakes_h

#include <signorini/simulation/preflight.h>

namespace signorini
{
  /**
   * What is allowed but seldom meant: friction with a scheme whose contact forces alternate, and
   * pairs of which none meets before the end. A sentence each, with the remedy.
   */
  template <int dim>
  std::vector<std::string> usual_mistakes(const Scene<dim> &scene, const Preflight &preflight);

  /**
   * A sentence about each pair that takes the nodes of a much stiffer body for the contact, in
   * steps so long that this matters, or without inertia.
   */
  template <int dim>
  std::vector<std::string> stiff_slaves(const Scene<dim> &scene, double courant_number);
} // namespace signorini

#endif
