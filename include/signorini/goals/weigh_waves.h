// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_weigh_waves_h
#define signorini_goals_weigh_waves_h

#include <signorini/goals/contact_zones.h>

#include <deal.II/lac/vector.h>

namespace signorini
{
  /**
   * Raise the indicators of cells that are farther from the contact of their body than a few times
   * its size. Near contact the body is deformed as at rest, and the error of the force is of second
   * order: half the squared error of the displacement. Farther away there are waves. They bring
   * their errors back to the contact, with all that their way has added. Collective.
   * @param indicator eta_T by active_cell_index
   * @return the number of cells near the contact of their body, on all processes
   */
  template <int dim>
  double weigh_waves(const Mesh<dim>         &mesh,
                     const ContactZones<dim> &zones,
                     dealii::Vector<double>  &indicator);
} // namespace signorini

#endif
