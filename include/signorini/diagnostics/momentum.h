// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_momentum_h
#define signorini_diagnostics_momentum_h

#include <signorini/discretization/discretization.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Linear momentum int rho v and angular momentum int rho X x v about the origin of the scene. X
   * is the position in the reference configuration: of this quantity linear elasticity conserves
   * every component in free motion.
   */
  struct Momentum
  {
    std::array<double, 3> linear{};
    std::array<double, 3> angular{}; ///< only the last component in 2d
  };

  template <int dim>
  Momentum momentum(const Discretization<dim> &discretization, const State &state);

  /** Resultant of nodal forces. */
  template <int dim>
  std::array<double, 3> resultant(const Discretization<dim> &discretization, const Vector &forces);
} // namespace signorini

#endif
