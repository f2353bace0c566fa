// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_rigid_obstacle_h
#define signorini_obstacles_rigid_obstacle_h

#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace signorini
{
  /** The way from a point to the obstacle. */
  template <int dim>
  struct ObstacleProjection
  {
    double                 gap;    ///< distance, negative inside the obstacle
    dealii::Tensor<1, dim> normal; ///< nu: unit vector towards the obstacle, out of the body
  };

  /** A rigid, fixed obstacle, known by the closest point of its surface. */
  template <int dim>
  class RigidObstacle
  {
  public:
    virtual ~RigidObstacle() = default;

    virtual ObstacleProjection<dim> project(const dealii::Point<dim> &point) const = 0;
  };

  /** Section `Obstacles/<name>` of a scene. */
  template <int dim>
  struct NamedObstacle
  {
    std::string                               name;
    std::shared_ptr<const RigidObstacle<dim>> shape;
  };
} // namespace signorini

#endif
