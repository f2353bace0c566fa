// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  template <int dim>
  void declare_obstacle(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const List        point(Double(), dim, dim);
    const std::string zero = (dim == 2 ? "0, 0" : "0, 0, 0");
    const std::string up   = (dim == 2 ? "0, 1" : "0, 0, 1");
    prm.declare_entry(
      "Shape",
      name_of(ObstacleShape::plane),
      choices_of<ObstacleShape>(),
      "plane, sphere (in 2d: a circle), cylinder (3d, of infinite length), or function (the zero "
      "set of an expression).");
    prm.declare_entry("Point",
                      zero,
                      point,
                      "Plane: a point of its surface; cylinder: a point of its axis (length).");
    prm.declare_entry(
      "Normal",
      up,
      point,
      "Plane: points out of the obstacle, towards the bodies; any length but zero.");
    prm.declare_entry("Centre", zero, point, "Sphere: the centre (length).");
    prm.declare_entry("Radius", "1", Double(), "Sphere, cylinder: the radius (length), > 0.");
    prm.declare_entry("Axis", up, point, "Cylinder: direction of the axis; any length but zero.");
    prm.declare_entry("Bodies inside",
                      "false",
                      Bool(),
                      "Sphere, cylinder: the obstacle is hollow and the bodies are inside of it.");
    prm.declare_entry("Signed distance",
                      "",
                      Anything(),
                      "Function: expression in x, y, z (length), positive where the bodies may be, "
                      "near its zero set the distance to it. Example, a bowl: z - 0.1*(x^2 + y^2)");
  }

  namespace
  {
    template <int dim>
    dealii::Tensor<1, dim> direction(const SectionReader &in, const std::string &key)
    {
      const dealii::Tensor<1, dim> vector = in.point<dim>(key);
      if (!(vector.norm() > 0.))
        in.fail(key,
                "a zero vector has no direction. Make at least one component different from zero.");
      return vector;
    }

    std::string read_signed_distance_text(const SectionReader &in)
    {
      const std::string expression = in.text("Signed distance");
      if (expression.empty())
        in.fail("Signed distance",
                "an obstacle of shape `function` needs this expression. Give one, for example z - "
                "0.1*x^2.");
      return expression;
    }
  } // namespace

  template <int dim>
  ObstacleDescription<dim> parse_obstacle(const SectionReader &in, const std::string &name)
  {
    if (!in.given())
      in.fail("",
              "`Obstacles/Names` lists this obstacle, but it has no subsection. Add `subsection "
                + name + " ... end` in section Obstacles, or remove the name from the list.");
    ObstacleDescription<dim> obstacle;
    obstacle.name  = name;
    obstacle.shape = in.choice<ObstacleShape>("Shape");
    if (obstacle.shape == ObstacleShape::plane)
      {
        obstacle.point  = in.point<dim>("Point");
        obstacle.normal = direction<dim>(in, "Normal");
      }
    else if (obstacle.shape == ObstacleShape::function)
      {
        obstacle.signed_distance = read_signed_distance_text(in);
        check_expression<dim>(in, "Signed distance", obstacle.signed_distance, {}, "");
      }
    else
      {
        if (dim == 2 && obstacle.shape == ObstacleShape::cylinder)
          in.fail("Shape", "a cylinder exists in 3d only. In 2d use `sphere`, which is a circle.");
        obstacle.radius        = in.positive_number("Radius", "it is a length");
        obstacle.bodies_inside = in.flag("Bodies inside");
        if (obstacle.shape == ObstacleShape::sphere)
          obstacle.centre = in.point<dim>("Centre");
        else
          {
            obstacle.point = in.point<dim>("Point");
            obstacle.axis  = direction<dim>(in, "Axis");
          }
      }
    return obstacle;
  }

#define INSTANTIATE(dim)                                                                           \
  template void                     declare_obstacle<dim>(dealii::ParameterHandler &);             \
  template ObstacleDescription<dim> parse_obstacle<dim>(const SectionReader &, const std::string &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
