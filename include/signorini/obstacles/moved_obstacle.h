// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_moved_obstacle_h
#define signorini_obstacles_moved_obstacle_h

#include <signorini/obstacles/obstacle_motion.h>
#include <signorini/obstacles/rigid_obstacle.h>

#include <algorithm>

namespace signorini
{
  /**
   * An obstacle that moves, in a step: it is where it is at the end of the step, and conditions
   * compare with where it was at the start.
   */
  template <int dim>
  class MovedObstacle : public RigidObstacle<dim>
  {
  public:
    /** At time 0. */
    MovedObstacle(const NamedObstacle<dim> &obstacle);

    /** A step from one time to another; both may be the same. */
    void move(double start, double end);

    ObstacleProjection<dim> project(const dealii::Point<dim> &p) const override
    {
      return turned(shape->project(after.back(p)), after);
    }
    /** At the start of the step. */
    ObstacleProjection<dim> project_before(const dealii::Point<dim> &p) const
    {
      return turned(shape->project(before.back(p)), before);
    }
    std::optional<ObstacleProjection<dim>> try_project(const dealii::Point<dim> &p) const override;
    std::optional<ObstacleProjection<dim>> try_project_before(const dealii::Point<dim> &p) const;

    bool has_end() const override { return shape->has_end(); }
    bool is_flat() const override { return shape->is_flat() && !(motion && motion->turns()); }

    double lever(const dealii::Point<dim> &p) const override
    {
      const double of_shape = shape->lever(after.back(p));
      return motion ? std::max(of_shape, p.distance(after.centre)) : of_shape;
    }

    /** The number of conditions that may hold one point: more than one in inner corners. */
    unsigned int most_conditions() const { return parts.empty() ? 1 : dim; }

    /** One of its sides, see RigidObstacle::sides(). */
    const MovedObstacle &side(const unsigned int k) const { return parts[k]; }

    /** Through the step. */
    std::vector<unsigned int> sides_near(const dealii::Point<dim> &start,
                                         const dealii::Point<dim> &end,
                                         const double              reach) const override
    {
      return shape->sides_near(before.back(start), after.back(end), reach);
    }

    /** At the end of the step. */
    std::vector<std::array<dealii::Point<dim>, dim>> facets() const override;

    /** Whether it does not move. */
    bool is_at_rest() const { return motion == nullptr; }

    /** Of what of it is here at the end of the step, the mean over the step; 0 without one. */
    dealii::Tensor<1, dim> velocity(const dealii::Point<dim> &end) const
    {
      return motion && duration > 0. ? (end - before.forth(after.back(end))) / duration
                                     : dealii::Tensor<1, dim>();
    }

    /** The length of a motion through the step, as seen from the obstacle. */
    double relative_motion(const dealii::Point<dim> &start, const dealii::Point<dim> &end) const
    {
      return motion ? before.back(start).distance(after.back(end)) : start.distance(end);
    }

    /** By which it turns in the step: radians. */
    double turn() const { return std::abs(after.angle - before.angle); }

    /**
     * That of the motion relative to the obstacle, in which it is at rest. With mean places of both
     * at the middle, x1 - x0 = R_m (X1 - X0) + s, R_m the mean rotation and s the motion of the
     * obstacle at the mean of X0 and X1.
     */
    MotionCondition<dim> condition_of_motion(const dealii::Point<dim> &start,
                                             const dealii::Point<dim> &end) const override;

    /**
     * The plane that touches the obstacle where a motion ends: its normal is that of the end, and
     * the gap that it tells is exact there, and of second order in distances from there.
     */
    MotionCondition<dim> condition_at_end(const dealii::Point<dim> &start,
                                          const dealii::Point<dim> &end) const;

    /**
     * How deep a point gets on its way through the step, without its ends. Stretches of the way are
     * halved until none can be deeper by more than what is noticed. Length, 0: never inside.
     * @param noticed length > 0
     */
    double depth_on_way(const dealii::Point<dim> &start,
                        const dealii::Point<dim> &end,
                        double                    noticed) const;

    /**
     * How deep a point that goes straight through the step is in the obstacle in between, where
     * that does not go straight; length.
     */
    double depth_between(const dealii::Point<dim> &start, const dealii::Point<dim> &end) const;

  private:
    std::shared_ptr<const RigidObstacle<dim>>  shape;
    std::shared_ptr<const ObstacleMotion<dim>> motion; ///< null: at rest
    ObstaclePlace<dim>                         before, after;
    double                                     duration = 0.; ///< of the step
    std::vector<ObstaclePlace<dim>>            between;       ///< see ObstacleMotion
    std::vector<MovedObstacle>                 parts;         ///< its sides

    static ObstacleProjection<dim> turned(ObstacleProjection<dim>   way,
                                          const ObstaclePlace<dim> &place)
    {
      way.normal = place.rotation * way.normal;
      return way;
    }
  };
} // namespace signorini

#endif
