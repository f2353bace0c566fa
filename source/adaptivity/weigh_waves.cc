// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/weigh_waves.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /** Measured, on discs and balls that hit a plane fast and slowly (doc/adaptivity.md). */
    constexpr double far_away = 4.; ///< in units of the size of the contact
    constexpr double weight   = 2.; ///< of squared indicators
  }                                 // namespace


  template <int dim>
  double weigh_waves(const Discretization<dim> &discretization,
                     const std::vector<bool>   &in_contact,
                     dealii::Vector<double>    &indicator)
  {
    const Mesh<dim>    &mesh         = discretization.mesh();
    const MPI_Comm      communicator = discretization.communicator();
    const unsigned int  n_bodies     = mesh.bodies().size();
    std::vector<double> centres((dim + 1) * n_bodies, 0.), sizes(n_bodies, 0.);
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned() && in_contact[cell->active_cell_index()])
        {
          double *centre = &centres[(dim + 1) * cell->material_id()];
          for (unsigned int c = 0; c < dim; ++c)
            centre[c] += cell->center()[c] * cell->measure();
          centre[dim] += cell->measure();
        }
    dealii::Utilities::MPI::sum(centres, communicator, centres);
    const auto distance = [&](const auto &cell) {
      const double *centre = &centres[(dim + 1) * cell->material_id()];
      double        square = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        square += std::pow(cell->center()[c] - centre[c] / centre[dim], 2);
      return std::sqrt(square);
    };
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned() && in_contact[cell->active_cell_index()])
        {
          double &size = sizes[cell->material_id()];
          size         = std::max(size, distance(cell));
        }
    dealii::Utilities::MPI::max(sizes, communicator, sizes);
    unsigned int n_near = 0;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          const unsigned int body = cell->material_id();
          if (centres[(dim + 1) * body + dim] == 0.)
            continue;
          if (distance(cell) > far_away * sizes[body])
            indicator(cell->active_cell_index()) *= std::sqrt(weight);
          else
            ++n_near;
        }
    return dealii::Utilities::MPI::sum(n_near, communicator);
  }


  template double
  weigh_waves(const Discretization<2> &, const std::vector<bool> &, dealii::Vector<double> &);
  template double
  weigh_waves(const Discretization<3> &, const std::vector<bool> &, dealii::Vector<double> &);
} // namespace signorini
