// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_rigid_obstacle_h
#define signorini_contact_rigid_obstacle_h

#include <signorini/model/obstacle_description.h>

#include <memory>

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

  /** plane, sphere, cylinder or function, as the description says. */
  template <int dim>
  std::unique_ptr<RigidObstacle<dim>> make_obstacle(const ObstacleDescription<dim> &description);
} // namespace signorini

#endif
