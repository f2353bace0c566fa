// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_obstacle_series_h
#define signorini_output_obstacle_series_h

#include <signorini/discretization/discretization.h>
#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/output/field_series.h>
#include <signorini/time/state.h>

namespace signorini
{
  /** `obstacles.pvd`: the surfaces of the obstacles that move, moment by moment. */
  template <int dim>
  class ObstacleSeries
  {
  public:
    /** Collective. The .pvd of an earlier run in this directory is removed. */
    ObstacleSeries(const std::string                     &directory,
                   const std::vector<NamedObstacle<dim>> &obstacles,
                   MPI_Comm                               communicator);

    /**
     * Write a moment: surfaces without end near to where the bodies are then. Collective.
     * @throws RunError on all processes if a file cannot be written
     */
    void write(const State &state, const Discretization<dim> &discretization);

    /** The moments so far. */
    void archive(Archive &archive) { series.archive(archive); }

  private:
    const std::vector<NamedObstacle<dim>> obstacles;
    const MPI_Comm                        communicator;
    FieldSeries                           series;
  };
} // namespace signorini

#endif
