// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/schemes/end_of_step.h>

namespace signorini
{
  State end_of_step(DynamicalSystem &system,
                    const State     &start,
                    const double     step_size,
                    const Vector    &increment,
                    const Vector    &velocity_change,
                    Vector         &&contact_force,
                    FrictionState  &&friction)
  {
    State end;
    end.step         = start.step + 1;
    end.time         = start.time + step_size;
    end.displacement = start.displacement;
    end.displacement += increment;
    end.velocity = start.velocity;
    end.velocity += velocity_change;
    end.contact_force.swap(contact_force);
    end.momentum       = start.momentum;
    end.internal_force = start.internal_force;
    if (!is_trial(system))
      {
        system.apply_mass(end.momentum, end.velocity);
        system.apply_stiffness(end.internal_force, end.displacement);
      }
    std::swap(end.friction, friction);
    return end;
  }


  double damping_work(DynamicalSystem &system, const Vector &increment, const double step_size)
  {
    const ViscousDamping *damping = system.capabilities().damping;
    if (damping == nullptr || is_trial(system))
      return 0.;
    Vector force = system.make_vector();
    damping->apply_damping(force, increment);
    return -(force * increment) / step_size;
  }
} // namespace signorini
