// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_end_of_step_h
#define signorini_schemes_end_of_step_h

#include <signorini/time/time_scheme.h>

namespace signorini
{
  /**
   * The complete state at the end of a step, u + d and v + velocity_change with the products M v
   * and A u. The state at its start is not touched: schemes swap both when nothing can fail any
   * more. In a trial the products are those of the start.
   */
  State end_of_step(DynamicalSystem &system,
                    const State     &start,
                    double           step_size,
                    const Vector    &increment,
                    const Vector    &velocity_change,
                    Vector         &&contact_force,
                    FrictionState  &&friction = {});

  /** The work of viscous damping, -d'C d/tau; zero in a system without, and in a trial.
   */
  double damping_work(DynamicalSystem &system, const Vector &increment, double step_size);
} // namespace signorini

#endif
