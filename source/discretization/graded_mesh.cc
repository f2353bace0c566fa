// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/graded_mesh.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Of Courant numbers, half an octave each; what is below the first has no say. */
    constexpr unsigned int n_classes = 80;

    /** That a wave passes on its way, per cell across. */
    constexpr double cells_of_a_wave = 3.;
  } // namespace


  template <int dim>
  double effective_courant_number(const Mesh<dim> &mesh, const double step_size)
  {
    const std::size_t   n_bodies = mesh.bodies().size();
    std::vector<double> n_cells(n_bodies * n_classes, 0.); // of a body, class by class
    double              largest = 0.;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        {
          const double number = mesh.courant_number(cell, step_size);
          const auto   k      = static_cast<unsigned int>(2. * std::log2(std::max(number, 1.)));
          n_cells[cell->material_id() * n_classes + std::min(k, n_classes - 1)] += 1.;
          largest = std::max(largest, number);
        }
    largest = Utilities::MPI::max(largest, mesh.communicator());
    Utilities::MPI::sum(n_cells, mesh.communicator(), n_cells);

    double result = 0.;
    for (auto body = n_cells.begin(); body != n_cells.end(); body += n_classes)
      {
        const double half      = 0.5 * std::accumulate(body, body + n_classes, 0.);
        double       n_smaller = 0.;
        for (unsigned int k = n_classes; k-- > 0 && n_smaller < half;)
          {
            n_smaller += body[k];
            const double number = std::exp2(0.5 * (k + 1)),
                         as_far = cells_of_a_wave * std::pow(n_smaller, 1. / dim);
            result = std::max(result, n_smaller < half ? std::min(number, as_far) : number);
          }
      }
    return std::min(result, largest);
  }


  template <int dim>
  double grading(const Mesh<dim> &mesh)
  {
    const unsigned int  n_levels = mesh.triangulation().n_global_levels();
    std::vector<double> n_cells(mesh.bodies().size() * n_levels, 0.);
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        n_cells[cell->material_id() * n_levels + cell->level()] += 1.;
    Utilities::MPI::sum(n_cells, mesh.communicator(), n_cells);
    double n_alike = 0.;
    for (auto body = n_cells.begin(); body != n_cells.end(); body += n_levels)
      n_alike += *std::max_element(body, body + n_levels);
    return 1. - n_alike / mesh.triangulation().n_global_active_cells();
  }


  template double effective_courant_number(const Mesh<2> &, double);
  template double effective_courant_number(const Mesh<3> &, double);
  template double grading(const Mesh<2> &);
  template double grading(const Mesh<3> &);
} // namespace signorini
