// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_obstacle_surfaces_h
#define signorini_output_obstacle_surfaces_h

#include <signorini/obstacles/rigid_obstacle.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <vector>

namespace signorini
{
  /**
   * The surfaces of rigid obstacles in a box, as lines or triangles, each with the index of its
   * obstacle: the zero set of the distance, found by marching cubes on a grid and moved onto the
   * obstacle. Details smaller than a cell of the grid are lost, and what is that near to points
   * where a distance has no value or no gradient.
   */
  template <int dim>
  class ObstacleSurfaces : public dealii::DataOutInterface<dim - 1, dim>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<dim - 1, dim>;

    ObstacleSurfaces(const std::vector<NamedObstacle<dim>> &obstacles,
                     const dealii::BoundingBox<dim>        &box);

    const std::vector<Patch> &get_patches() const override { return patches; }
    std::vector<std::string>  get_dataset_names() const override { return {"obstacle"}; }

  private:
    std::vector<Patch> patches;

    void add_patch(const RigidObstacle<dim>              &obstacle,
                   unsigned int                           index,
                   const std::vector<dealii::Point<dim>> &vertices);
  };

  /** A box around bodies and the nearest points of the obstacles, with half a body's size to spare.
   */
  template <int dim>
  dealii::BoundingBox<dim> surroundings(const std::vector<dealii::BoundingBox<dim>> &bodies,
                                        const std::vector<NamedObstacle<dim>>       &obstacles);

  /** Write `obstacles.vtu`. Collective. @throws RunError on all processes if that is not possible.
   */
  template <int dim>
  void write_obstacles(const std::string                           &directory,
                       const std::vector<dealii::BoundingBox<dim>> &bodies,
                       const std::vector<NamedObstacle<dim>>       &obstacles,
                       MPI_Comm                                     communicator);
} // namespace signorini

#endif
