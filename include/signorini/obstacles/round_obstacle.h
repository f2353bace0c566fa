// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_round_obstacle_h
#define signorini_obstacles_round_obstacle_h

#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/prm/section_reader.h>

namespace signorini
{
  /** Sphere, circle (2d), and cylinder, which is the sphere of the plane across its axis. */
  template <int dim>
  class RoundObstacle : public RigidObstacle<dim>
  {
  public:
    /**
     * @param axis          zero for a sphere; otherwise of any length
     * @param bodies_inside the obstacle is hollow
     */
    RoundObstacle(const dealii::Point<dim>     &centre,
                  const dealii::Tensor<1, dim> &axis,
                  double                        radius,
                  bool                          bodies_inside);

    ObstacleProjection<dim> project(const dealii::Point<dim> &p) const override;

    double lever(const dealii::Point<dim> &p) const override { return arm(p).norm(); }

    /** Exact, without a singularity where the motion is small. */
    MotionCondition<dim> condition_of_motion(const dealii::Point<dim> &start,
                                             const dealii::Point<dim> &end) const override;

  private:
    const dealii::Point<dim>     centre;
    const dealii::Tensor<1, dim> axis;
    const double                 radius;
    const double                 sign;

    /** From the centre or the axis to a point. */
    dealii::Tensor<1, dim> arm(const dealii::Point<dim> &p) const;
  };

  template <int dim>
  void declare_sphere(dealii::ParameterHandler &prm);
  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_sphere(const SectionReader &in,
                                                         const std::string   &name);

  template <int dim>
  void declare_cylinder(dealii::ParameterHandler &prm);
  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_cylinder(const SectionReader &in,
                                                           const std::string   &name);
} // namespace signorini

#endif
