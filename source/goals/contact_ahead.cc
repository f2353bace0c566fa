// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/goals/contact_ahead.h>

#include <deal.II/base/mpi.h>

#include <limits>

namespace signorini
{
  namespace
  {
    /** Of the finest cell in contact: what is closer is about to touch. */
    constexpr double near = 0.25;

    /**
     * In the plane cells ahead are cheap, and changes of the mesh are not. In space a wide zone has
     * many cells: two to three times as many degrees of freedom for the punch of the study.
     */
    constexpr double far_enough_in_the_plane = 1. / 8., grading_in_the_plane = 2.;
  } // namespace


  template <int dim>
  ContactAhead contact_ahead(const Mesh<dim> &mesh, const std::vector<bool> &in_contact)
  {
    constexpr double          none = std::numeric_limits<double>::max();
    std::vector<unsigned int> finest(mesh.bodies().size(), 0);
    double                    size = none;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned() && in_contact[cell->active_cell_index()])
        {
          unsigned int &level = finest[cell->material_id()];
          level               = std::max(level, static_cast<unsigned int>(cell->level()));
          size                = std::min(size, cell->diameter() / std::sqrt(double(dim)));
        }
    dealii::Utilities::MPI::max(finest, mesh.communicator(), finest);
    size = dealii::Utilities::MPI::min(size, mesh.communicator());
    ContactAhead result{size < none ? near * size : 0., finest};
    if (dim == 2)
      {
        result.far_enough = far_enough_in_the_plane;
        result.grading    = grading_in_the_plane;
      }
    return result;
  }


  template ContactAhead contact_ahead(const Mesh<2> &, const std::vector<bool> &);
  template ContactAhead contact_ahead(const Mesh<3> &, const std::vector<bool> &);
} // namespace signorini
