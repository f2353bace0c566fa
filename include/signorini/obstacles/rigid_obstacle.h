// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_rigid_obstacle_h
#define signorini_obstacles_rigid_obstacle_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

  /** For a point that is far, or of which an obstacle knows nothing. */
  template <int dim>
  ObstacleProjection<dim> far_projection()
  {
    constexpr double       infinity = std::numeric_limits<double>::infinity();
    dealii::Tensor<1, dim> any;
    any[dim - 1] = 1.;
    return {infinity, any, infinity};
  }

  /**
   * A linear condition on the motion d of a point that says what its gap g at the end of the motion
   * says: g = gap_per_slack (bound - normal.d). At an edge there may be none; then it is the plane
   * of the start of the motion, which keeps the point out of what is convex.
   */
  template <int dim>
  struct MotionCondition
  {
    dealii::Tensor<1, dim> normal; ///< unit vector towards the obstacle
    double                 bound;  ///< length
    double                 gap_per_slack   = 1.;
    bool                   is_exact        = true; ///< says it, and is not only safe
    dealii::Tensor<1, dim> obstacle_motion = {}; ///< of its surface at the point, in the same time

    /** What the condition takes for the gap at the end of a motion. */
    double gap_after(const dealii::Tensor<1, dim> &motion) const
    {
      return gap_per_slack * (bound - normal * motion);
    }
  };

  template <int dim>
  class ObstacleMotion;

  /** A rigid obstacle, known by the closest point of its surface. */
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

    /**
     * Smooth parts of its surface, each as an obstacle of its own, if some of them meet in inner
     * corners: there more than one of them holds a point.
     */
    virtual std::vector<std::shared_ptr<const RigidObstacle<dim>>> sides() const { return {}; }

    /**
     * Where several sides hold a point in a motion: that of the closest point at the start, and up
     * to dim - 1 others that meet it in inner corners, nearest first. Otherwise none, also where a
     * motion leads past them. Sides that are farther away than the last argument, a length, do not
     * count.
     */
    virtual std::vector<unsigned int> sides_near(const dealii::Point<dim> & /*start*/,
                                                 const dealii::Point<dim> & /*end*/,
                                                 double /*reach*/) const
    {
      return {};
    }

    /** Its surface, if it consists of flat facets. */
    virtual std::vector<std::array<dealii::Point<dim>, dim>> facets() const { return {}; }

    /** The path of the file that it comes from; empty if there is none. */
    virtual std::string file() const { return {}; }

    /**
     * The largest length with which the gap of a point is computed, beside its coordinates: it has
     * the round-off of that.
     */
    virtual double lever(const dealii::Point<dim> & /*point*/) const { return 0.; }

    /** Whether all normals are the same, at all times. */
    virtual bool is_flat() const { return false; }

    /**
     * The condition whose normal is the discrete gradient of the gap over a motion,
     *
     *   -nu.(end - start) = g(end) - g(start),
     *
     * scaled to a unit vector; its bound is then g(start), scaled alike, whatever the motion turns
     * out to be (Gonzalez, Comput. Methods Appl. Mech. Engrg. 190 (2000) 1763-1783, equation (24)).
     * It is the normal in the middle, tilted along the motion. Where that takes more than
     * `largest_tilt`, at edges, or where the motion leads to where the obstacle has no value, it is
     * not exact.
     */
    virtual MotionCondition<dim> condition_of_motion(const dealii::Point<dim> &start,
                                                     const dealii::Point<dim> &end) const;

    /** Of the normal of a condition against that in the middle of the motion: radians. */
    static constexpr double largest_tilt = 0.1;
  };

  /** Section `Obstacles/<name>` of a scene. */
  template <int dim>
  struct NamedObstacle
  {
    std::string                                name;
    std::shared_ptr<const RigidObstacle<dim>>  shape;            ///< at time 0, before any motion
    std::shared_ptr<const ObstacleMotion<dim>> motion = nullptr; ///< null: it stays there
  };
} // namespace signorini

#endif
