// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/obstacle_series.h>
#include <signorini/output/obstacle_surfaces.h>
#include <signorini/output/whole_file.h>

#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Around all bodies as they are. Collective. */
    template <int dim>
    BoundingBox<dim> present_box(const Discretization<dim> &discretization,
                                 const Vector              &displacement)
    {
      std::vector<double> ends(2 * dim, std::numeric_limits<double>::max());
      for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const double place =
              discretization.node_positions()[node][c] + displacement.local_element(dim * node + c);
            ends[2 * c]     = std::min(ends[2 * c], place);
            ends[2 * c + 1] = std::min(ends[2 * c + 1], -place);
          }
      Utilities::MPI::min(ends, discretization.communicator(), ends);
      Point<dim> lower, upper;
      for (unsigned int c = 0; c < dim; ++c)
        {
          lower[c] = ends[2 * c];
          upper[c] = -ends[2 * c + 1];
        }
      return BoundingBox<dim>({lower, upper});
    }
  } // namespace


  template <int dim>
  ObstacleSeries<dim>::ObstacleSeries(const std::string                     &directory,
                                      const std::vector<NamedObstacle<dim>> &obstacles,
                                      const MPI_Comm                         communicator)
    : obstacles(obstacles)
    , communicator(communicator)
    , series(directory, "obstacles", communicator)
  {
  }


  template <int dim>
  void ObstacleSeries<dim>::write(const State &state, const Discretization<dim> &discretization)
  {
    // The first process has the surfaces, the others write pieces without any.
    const BoundingBox<dim>          bodies = present_box(discretization, state.displacement);
    std::vector<ShownObstacle<dim>> shown;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      shown = shown_obstacles(obstacles, true, state.time);
    ObstacleSurfaces<dim> surfaces(shown, surroundings({bodies}, shown));
    succeed_together(communicator, [&] { series.write_piece(surfaces, state.step, state.time); });
    series.name_moment(surfaces, state.step, state.time);
  }


  template class ObstacleSeries<2>;
  template class ObstacleSeries<3>;
} // namespace signorini
