// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/goals/base_levels.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** Of what is tolerated: more in 3d, where a level has eight times the cells. */
    template <int dim>
    constexpr double good_part = dim == 2 ? 1. / 3. : 1. / 2.;

    /** Of a cell in units of its share: what is more is a matter of this cell. */
    constexpr double most_diffuse = 4.;
  } // namespace


  template <int dim>
  BaseLevels<dim>::BaseLevels(const Mesh<dim> &mesh)
    : mesh(mesh)
    , levels(mesh.bodies().size(), 0)
  {
  }


  template <int dim>
  void BaseLevels<dim>::see(const dealii::Vector<double> &indicator,
                            const double                  tolerated,
                            const std::vector<bool>      &matters)
  {
    const auto               &cells = mesh.triangulation();
    std::vector<unsigned int> coarsest(levels.size(), std::numeric_limits<unsigned int>::max());
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          unsigned int &level = coarsest[cell->material_id()];
          level               = std::min(level, static_cast<unsigned int>(cell->level()));
        }
    dealii::Utilities::MPI::min(coarsest, mesh.communicator(), coarsest);

    const double        share = tolerated / cells.n_global_active_cells();
    std::vector<double> diffuse(levels.size(), 0.);
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          const unsigned int body = cell->material_id(), level = cell->level();
          const double       square = std::pow(indicator(cell->active_cell_index()), 2);
          if (level == coarsest[body])
            diffuse[body] += std::min(square, most_diffuse * share);
        }
    dealii::Utilities::MPI::sum(diffuse, mesh.communicator(), diffuse);
    for (unsigned int body = 0; body < levels.size(); ++body)
      if (!matters[body])
        levels[body] = 0;
      else if (diffuse[body] > good_part<dim> * tolerated)
        levels[body] = coarsest[body] + 1;
  }


  template class BaseLevels<2>;
  template class BaseLevels<3>;
} // namespace signorini
