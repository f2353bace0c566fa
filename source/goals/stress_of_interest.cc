// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/goals/stress_of_interest.h>

namespace signorini
{
  template <int dim>
  Stresses<dim> stresses_of_interest(const GoalKind                                 goal,
                                     const std::vector<ProbeDescription<dim>>      &probes,
                                     const std::vector<PointProbeDescription<dim>> &point_probes,
                                     const Discretization<dim>                     &discretization,
                                     const ContactSurface<dim>                     &surface)
  {
    Stresses<dim> result;
    if (goal == GoalKind::contact_pressure)
      result.push_back(make_contact_pressure(discretization, surface));
    if (goal == GoalKind::probe)
      {
        for (const auto &probe : probes)
          result.push_back(make_probed_stress(probe, discretization, surface));
        for (const auto &probe : point_probes)
          result.push_back(make_probed_stress(probe, discretization));
      }
    return result;
  }


  template Stresses<2> stresses_of_interest(GoalKind,
                                            const std::vector<ProbeDescription<2>> &,
                                            const std::vector<PointProbeDescription<2>> &,
                                            const Discretization<2> &,
                                            const ContactSurface<2> &);
  template Stresses<3> stresses_of_interest(GoalKind,
                                            const std::vector<ProbeDescription<3>> &,
                                            const std::vector<PointProbeDescription<3>> &,
                                            const Discretization<3> &,
                                            const ContactSurface<3> &);
} // namespace signorini
