// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/step_size/contact_events.h>
#include <signorini/step_size/energy_norm.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  ActiveSet contact_statuses(const DynamicalSystem &system, const State &state)
  {
    const NormalGap force   = system.own_normal_forces(state.contact_force);
    double          largest = 0.;
    for (const double value : force)
      largest = std::max(largest, std::abs(value));
    largest = dealii::Utilities::MPI::max(largest, state.contact_force.get_mpi_communicator());

    const double threshold =
      unnoticed_force * std::max(largest, energy_of_motion(state) / system.length());
    ActiveSet result(force.size(), contact_status::open);
    for (std::size_t k = 0; k < force.size(); ++k)
      if (force[k] < -threshold)
        {
          const bool sticks =
            state.friction.any() && contact_status::sticks(state.friction.status[k]);
          result[k] = sticks ? contact_status::stick : contact_status::slip;
        }
    return result;
  }


  bool any_contact(const ActiveSet &statuses, const Vector &like)
  {
    return differ(statuses, ActiveSet(statuses.size(), contact_status::open), like);
  }


  bool differ(const ActiveSet &a, const ActiveSet &b, const Vector &like)
  {
    return dealii::Utilities::MPI::max(static_cast<unsigned int>(a != b),
                                       like.get_mpi_communicator())
           > 0;
  }


  double time_to_touch(DynamicalSystem &system, const State &state, const double horizon)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (any_contact(contact_statuses(system, state), state.displacement))
      return infinity;
    // Contact that follows the motion sees what a step of this size may reach, and moves obstacles.
    if (MovingContact *following = system.capabilities().moving_contact)
      try
        {
          following->begin_step(state, horizon, StepNormals::of_motion);
        }
      catch (const StepError &)
        {
          return infinity; // steps that cannot be begun say so themselves
        }
    Vector way = state.velocity;
    way *= horizon;
    const NormalGap gap      = gaps_at_start(system, system.normal_gap(state.displacement)),
                    approach = motion_past_obstacles(system, way);
    const double touching    = touching_distance(system.length());
    double       first       = infinity;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (approach[k] > gap[k] + touching)
        first = std::min(first, horizon * std::max(0., gap[k]) / approach[k]);
    return dealii::Utilities::MPI::min(first, state.displacement.get_mpi_communicator());
  }
} // namespace signorini
