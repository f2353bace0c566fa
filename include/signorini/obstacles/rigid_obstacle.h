// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_rigid_obstacle_h
#define signorini_obstacles_rigid_obstacle_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace signorini
{
  /** The way from a point to the obstacle. */
  template <int dim>
  struct ObstacleProjection
  {
    double                 gap;    ///< distance, negative inside the obstacle
    dealii::Tensor<1, dim> normal; ///< nu: unit vector towards the obstacle, out of the body
    /** How far the point is past the end of the obstacle, along the surface; negative before it. */
    double beyond = -std::numeric_limits<double>::infinity();

    /** How deep the point is inside: the way out is through the surface or through the end. */
    double depth() const { return std::max(0., std::min(-gap, -beyond)); }

    /**
     * Whether the surface holds the point up. It does not past the end, nor what has come in there.
     * @param tolerance length
     */
    bool is_carried(const double tolerance) const
    {
      return beyond + std::max(0., -gap) <= tolerance;
    }

    /** Distance to what is inside, whichever way; 0 there. */
    double distance() const { return std::hypot(std::max(0., gap), std::max(0., beyond)); }
  };

  /** A rigid, fixed obstacle, known by the closest point of its surface. */
  template <int dim>
  class RigidObstacle
  {
  public:
    virtual ~RigidObstacle() = default;

    /** @throws UserError where the obstacle has no value or no normal */
    virtual ObstacleProjection<dim> project(const dealii::Point<dim> &point) const = 0;

    /** The same, but nothing where project() throws: for points where no contact has to be. */
    virtual std::optional<ObstacleProjection<dim>>
    try_project(const dealii::Point<dim> &point) const
    {
      return project(point);
    }

    /** Whether projections may be past an end. */
    virtual bool has_end() const { return false; }
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
