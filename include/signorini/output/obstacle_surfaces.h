// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_obstacle_surfaces_h
#define signorini_output_obstacle_surfaces_h

#include <signorini/obstacles/moved_obstacle.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <vector>

namespace signorini
{
  /** An obstacle where it is, and its index among all of the scene. */
  template <int dim>
  struct ShownObstacle
  {
    unsigned int       index;
    MovedObstacle<dim> obstacle;
  };

  /**
   * The obstacles that rest, or those that move, at a time.
   */
  template <int dim>
  std::vector<ShownObstacle<dim>>
  shown_obstacles(const std::vector<NamedObstacle<dim>> &obstacles, bool moving, double time = 0.);

  /**
   * The surfaces of rigid obstacles, as lines or triangles, each with the index of its obstacle.
   * What consists of facets is shown as it is. Of others the part in a box is shown: the zero set
   * of the distance, found by marching cubes on a grid and moved onto the obstacle. Details smaller
   * than a cell of the grid are lost, and what is that near to points where a distance has no value
   * or no gradient.
   */
  template <int dim>
  class ObstacleSurfaces : public dealii::DataOutInterface<dim - 1, dim>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<dim - 1, dim>;

    ObstacleSurfaces(const std::vector<ShownObstacle<dim>> &obstacles,
                     const dealii::BoundingBox<dim>        &box);

    const std::vector<Patch> &get_patches() const override { return patches; }
    std::vector<std::string>  get_dataset_names() const override { return {"obstacle"}; }

  private:
    std::vector<Patch> patches;

    void add_zero_sets(const std::vector<ShownObstacle<dim>> &obstacles,
                       const dealii::BoundingBox<dim>        &box);
    /** A piece near an obstacle, moved onto it. */
    void add_piece(const ShownObstacle<dim> &shown, std::vector<dealii::Point<dim>> vertices);
    template <typename Vertices>
    void add_patch(unsigned int index, const Vertices &vertices);
  };

  /** A box around bodies and the nearest points of the obstacles, with half a body's size to spare.
   */
  template <int dim>
  dealii::BoundingBox<dim> surroundings(const std::vector<dealii::BoundingBox<dim>> &bodies,
                                        const std::vector<ShownObstacle<dim>>       &obstacles);

  /**
   * Write `obstacles.vtu` with the obstacles that rest, if there are any. Collective.
   * @throws RunError on all processes if that is not possible.
   */
  template <int dim>
  void write_obstacles(const std::string                           &directory,
                       const std::vector<dealii::BoundingBox<dim>> &bodies,
                       const std::vector<NamedObstacle<dim>>       &obstacles,
                       MPI_Comm                                     communicator);
} // namespace signorini

#endif
