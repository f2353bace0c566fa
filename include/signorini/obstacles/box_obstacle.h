// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_box_obstacle_h
#define signorini_obstacles_box_obstacle_h

#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/prm/section_reader.h>

namespace signorini
{
  /**
   * A box along the axes (2d: a rectangle). Beside its edges and corners the distance is that to
   * them, and the normal points there; inside, the nearest face counts.
   */
  template <int dim>
  class BoxObstacle : public RigidObstacle<dim>
  {
  public:
    BoxObstacle(const dealii::Point<dim> &lower, const dealii::Point<dim> &upper);

    ObstacleProjection<dim> project(const dealii::Point<dim> &p) const override;

  private:
    const dealii::Point<dim> lower, upper;
  };

  template <int dim>
  void declare_box(dealii::ParameterHandler &prm);

  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_box(const SectionReader &in,
                                                      const std::string   &name);
} // namespace signorini

#endif
