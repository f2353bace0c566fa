// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_plane_h
#define signorini_obstacles_plane_h

#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/prm/section_reader.h>

namespace signorini
{
  /** A half space. */
  template <int dim>
  class Plane : public RigidObstacle<dim>
  {
  public:
    /** @param normal out of the obstacle, towards the bodies; any length > 0 */
    Plane(const dealii::Point<dim> &point, const dealii::Tensor<1, dim> &normal);

    ObstacleProjection<dim> project(const dealii::Point<dim> &p) const override;

  private:
    const dealii::Point<dim>     point;
    const dealii::Tensor<1, dim> normal;
  };

  template <int dim>
  void declare_plane(dealii::ParameterHandler &prm);

  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_plane(const SectionReader &in,
                                                        const std::string   &name);
} // namespace signorini

#endif
