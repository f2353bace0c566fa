// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/goals/weigh_waves.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /** Of squared indicators; measured as the distance that makes a cell far. */
    constexpr double weight = 2.;
  } // namespace


  template <int dim>
  double weigh_waves(const Mesh<dim>         &mesh,
                     const ContactZones<dim> &zones,
                     dealii::Vector<double>  &indicator)
  {
    unsigned int n_near = 0;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          if (!zones.touches(cell->material_id()))
            continue;
          if (zones.is_far(cell))
            indicator(cell->active_cell_index()) *= std::sqrt(weight);
          else
            ++n_near;
        }
    return dealii::Utilities::MPI::sum(n_near, mesh.communicator());
  }


  template double weigh_waves(const Mesh<2> &, const ContactZones<2> &, dealii::Vector<double> &);
  template double weigh_waves(const Mesh<3> &, const ContactZones<3> &, dealii::Vector<double> &);
} // namespace signorini
