// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_plane_h
#define signorini_obstacles_plane_h

#include <signorini/obstacles/rigid_obstacle.h>
#include <signorini/prm/section_reader.h>

#include <vector>

namespace signorini
{
  /**
   * A half space, or the block below a part of a plane: it ends where the part ends, and is as deep
   * as need be.
   */
  template <int dim>
  class Plane : public RigidObstacle<dim>
  {
  public:
    /** From the middle of the plane along a tangent and against it. */
    struct End
    {
      dealii::Tensor<1, dim> tangent; ///< unit vector
      double                 reach;   ///< half of the length
    };

    /**
     * @param normal out of the obstacle, towards the bodies; any length > 0
     * @param ends of the plane about the point, along tangents at right angles; none: infinite
     */
    Plane(const dealii::Point<dim>     &point,
          const dealii::Tensor<1, dim> &normal,
          std::vector<End>              ends = {});

    ObstacleProjection<dim> project(const dealii::Point<dim> &p) const override;

    bool has_end() const override { return !ends.empty(); }

    double lever(const dealii::Point<dim> &p) const override { return p.distance(point); }

    bool is_flat() const override { return true; }

    MotionCondition<dim> condition_of_motion(const dealii::Point<dim> &start,
                                             const dealii::Point<dim> &) const override
    {
      return {-normal, (start - point) * normal};
    }

  private:
    const dealii::Point<dim>     point;
    const dealii::Tensor<1, dim> normal;
    const std::vector<End>       ends;
  };

  template <int dim>
  void declare_plane(dealii::ParameterHandler &prm);

  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_plane(const SectionReader &in,
                                                        const std::string   &name);
} // namespace signorini

#endif
