// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_momentum_h
#define signorini_diagnostics_momentum_h

#include <signorini/discretization/discretization.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Linear momentum int rho v and angular momentum int rho x x v about the origin of the scene.
   * With x in the reference configuration linear elasticity conserves every component in free
   * motion, and contact that is linearised there has the moments that it counts. Where contact
   * follows the motion, its moments are those at the present positions; what is left then is that
   * of linear strains, of second order in the displacements that are no translation.
   */
  struct Momentum
  {
    std::array<double, 3> linear{};
    std::array<double, 3> angular{}; ///< only the last component in 2d
  };

  /** @param displacement from the reference configuration to x; null: none */
  template <int dim>
  Momentum momentum(const Discretization<dim> &discretization,
                    const State               &state,
                    const Vector              *displacement = nullptr);

  /** Resultant of nodal forces. */
  template <int dim>
  std::array<double, 3> resultant(const Discretization<dim> &discretization, const Vector &forces);
} // namespace signorini

#endif
