// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/common_boxes.h>
#include <signorini/output/obstacle_series.h>
#include <signorini/output/obstacle_surfaces.h>
#include <signorini/output/whole_file.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Around each body as it is. Collective. */
    template <int dim>
    std::vector<BoundingBox<dim>> present_boxes(const Discretization<dim> &discretization,
                                                const Vector              &displacement)
    {
      const std::vector<unsigned int> bodies = discretization.bodies_of_nodes();
      CommonBoxes<dim>                boxes(discretization.mesh().bodies().size());
      for (unsigned int node = 0; node < bodies.size(); ++node)
        if (bodies[node] != numbers::invalid_unsigned_int) // hanging nodes have no displacement
          {
            Point<dim> place = discretization.node_positions()[node];
            for (unsigned int c = 0; c < dim; ++c)
              place[c] += displacement.local_element(dim * node + c);
            boxes.add(place, bodies[node]);
          }
      return boxes.around_all(discretization.communicator());
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
    const auto                      bodies = present_boxes(discretization, state.displacement);
    std::vector<ShownObstacle<dim>> shown;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      shown = shown_obstacles(obstacles, true, state.time);
    ObstacleSurfaces<dim> surfaces(shown, surroundings(bodies, shown));
    succeed_together(communicator, [&] { series.write_piece(surfaces, state.step, state.time); });
    series.name_moment(surfaces, state.step, state.time);
  }


  template class ObstacleSeries<2>;
  template class ObstacleSeries<3>;
} // namespace signorini
