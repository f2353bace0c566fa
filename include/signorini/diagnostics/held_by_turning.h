// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_held_by_turning_h
#define signorini_diagnostics_held_by_turning_h

#include <signorini/discretization/discretization.h>
#include <signorini/time/state.h>

#include <string>

namespace signorini
{
  /**
   * Bodies that an equilibrium with friction holds only because they have turned. Linear strains
   * take the moments of forces about the undeformed body: where a round body has turned by an
   * angle, the nodes that bear it are beside its centre, and their forces resist, as if it lay on a
   * flat. In truth it would roll, or spin up. Such a body is out of balance, by as much as friction
   * would turn it, as soon as moments are taken at the places where the forces act. Collective.
   * @return a sentence for each of them
   */
  template <int dim>
  std::vector<std::string> held_by_turning(const Discretization<dim> &discretization,
                                           const State               &equilibrium);
} // namespace signorini

#endif
