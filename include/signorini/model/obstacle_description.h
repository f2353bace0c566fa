// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_obstacle_description_h
#define signorini_model_obstacle_description_h

#include <signorini/base/enum_names.h>

#include <deal.II/base/point.h>

#include <string>

namespace signorini
{
  /** What an obstacle is. */
  enum class ObstacleShape
  {
    plane,    ///< a half space
    sphere,   ///< in 2d a circle
    cylinder, ///< in 3d only, of infinite length
    function  ///< where an expression is negative
  };

  template <>
  struct EnumNames<ObstacleShape>
  {
    static constexpr EnumName<ObstacleShape> table[] = {{ObstacleShape::plane, "plane"},
                                                        {ObstacleShape::sphere, "sphere"},
                                                        {ObstacleShape::cylinder, "cylinder"},
                                                        {ObstacleShape::function, "function"}};
  };

  /** Section `Obstacles/<name>`: a rigid, fixed obstacle. */
  template <int dim>
  struct ObstacleDescription
  {
    std::string        name;
    ObstacleShape      shape = ObstacleShape::plane;
    dealii::Point<dim> point; ///< plane: a point of its surface; cylinder: a point of its axis
    dealii::Tensor<1, dim>
      normal; ///< plane: points out of the obstacle, towards the bodies (any length > 0)
    dealii::Point<dim>     centre;      ///< sphere
    double                 radius = 1.; ///< sphere, cylinder
    dealii::Tensor<1, dim> axis;        ///< cylinder (3d): direction of its axis
    bool bodies_inside = false; ///< sphere, cylinder: the bodies are inside (a hollow obstacle)
    std::string
      signed_distance; ///< function: expression in x, y, z; positive where the bodies may be
  };
} // namespace signorini

#endif
