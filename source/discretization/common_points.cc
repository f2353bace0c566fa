// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/common_points.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<Point<dim>> common_points(const std::vector<Point<dim>> &own,
                                        const MPI_Comm                 communicator)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return own;
    std::vector<double> coordinates;
    for (const Point<dim> &point : own)
      for (unsigned int c = 0; c < dim; ++c)
        coordinates.push_back(point[c]);
    std::vector<Point<dim>> result;
    for (const auto &of_process : Utilities::MPI::all_gather(communicator, coordinates))
      for (std::size_t first = 0; first < of_process.size(); first += dim)
        {
          Point<dim> &point = result.emplace_back();
          for (unsigned int c = 0; c < dim; ++c)
            point[c] = of_process[first + c];
        }
    return result;
  }


  template std::vector<Point<2>> common_points(const std::vector<Point<2>> &, MPI_Comm);
  template std::vector<Point<3>> common_points(const std::vector<Point<3>> &, MPI_Comm);
} // namespace signorini
