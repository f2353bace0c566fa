// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/goals/contact_zones.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace signorini
{
  template <int dim>
  ContactZones<dim>::ContactZones(const Mesh<dim> &mesh, const std::vector<bool> &in_contact)
    : in_contact(in_contact)
    , centres(mesh.bodies().size())
    , volumes(mesh.bodies().size(), 0.)
    , sizes(mesh.bodies().size(), 0.)
  {
    const auto is_in_contact = [&](const auto &cell) {
      return cell->is_locally_owned() && in_contact[cell->active_cell_index()];
    };
    std::vector<double> moments(dim * centres.size(), 0.);
    for (const auto &cell : mesh.active_cells())
      if (is_in_contact(cell))
        {
          const double volume = cell->measure();
          volumes[cell->material_id()] += volume;
          for (unsigned int c = 0; c < dim; ++c)
            moments[dim * cell->material_id() + c] += volume * cell->center()[c];
        }
    dealii::Utilities::MPI::sum(moments, mesh.communicator(), moments);
    dealii::Utilities::MPI::sum(volumes, mesh.communicator(), volumes);
    for (unsigned int body = 0; body < centres.size(); ++body)
      for (unsigned int c = 0; touches(body) && c < dim; ++c)
        centres[body][c] = moments[dim * body + c] / volumes[body];
    for (const auto &cell : mesh.active_cells())
      if (is_in_contact(cell))
        {
          double &size = sizes[cell->material_id()];
          size         = std::max(size, distance(cell));
        }
    dealii::Utilities::MPI::max(sizes, mesh.communicator(), sizes);
  }


  template class ContactZones<2>;
  template class ContactZones<3>;
} // namespace signorini
