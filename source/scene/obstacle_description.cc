// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/expressions.h>
#include <signorini/base/spelling.h>
#include <signorini/obstacles/obstacle_motion.h>
#include <signorini/obstacles/obstacle_table.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/prm/kinds_of_section.h>
#include <signorini/scene/sections.h>
#include <signorini/scene/time_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <map>
#include <regex>

namespace signorini
{
  namespace
  {
    template <int dim>
    void declare_obstacle_motion(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      const std::string zeros = dim == 2 ? "0; 0" : "0; 0; 0";
      prm.declare_entry("Motion",
                        zeros,
                        Anything(),
                        "Displacement of the obstacle: expressions of t (length). Needs "
                        "`Contact/Motion = follow`, as do the other motions of obstacles.");
      prm.declare_entry(
        "Velocity",
        zeros,
        Anything(),
        "Instead of `Motion`: velocity of the obstacle, expressions of t (length per "
        "time); it is where it is given at time 0.");
      prm.declare_entry("Angular velocity",
                        "0",
                        Anything(),
                        dim == 2 ? "An expression of t (radians per time), counterclockwise."
                                 : "An expression of t (radians per time), about `Rotation axis`.");
      prm.declare_entry(
        "Rotation centre",
        (dim == 2 ? "0, 0" : "0, 0, 0"),
        List(Double(), dim, dim),
        "With `Angular velocity`: a point of the axis at time 0 (length). `Motion` and "
        "`Velocity` take it along.");
      if (dim == 3)
        prm.declare_entry("Rotation axis",
                          "0, 0, 1",
                          List(Double(), dim, dim),
                          "With `Angular velocity`: its direction; any length but zero.");
    }


    template <int dim>
    void check_only_time(const SectionReader &in, const std::string &key)
    {
      static const std::regex place("\\b[xyz]\\b");
      if (std::regex_search(in.text(key), place))
        in.fail(key,
                "is a motion of the whole obstacle, and depends on t only. Remove x, y and z.");
    }


    /** Expressions of t for each component. */
    template <int dim>
    std::array<std::string, dim> read_motion(const SectionReader &in, const std::string &key)
    {
      check_only_time<dim>(in, key);
      return read_expressions<dim>(in, key, {dealii::Point<dim>()}, true);
    }


    /** A step notices what is not much shorter than it; load steps may be the whole time. */
    double panel_of_rates(const TimeParameters &time)
    {
      return std::min(time.step_size, time.end_time / 100.);
    }


    template <int dim>
    std::shared_ptr<const ObstacleMotion<dim>> parse_obstacle_motion(const SectionReader  &in,
                                                                     const std::string    &name,
                                                                     const TimeParameters &time)
    {
      typename ObstacleMotion<dim>::Description motion;
      motion.displacement = read_motion<dim>(in, "Motion");
      motion.velocity     = read_motion<dim>(in, "Velocity");
      if (is_given(motion.displacement) && is_given(motion.velocity))
        in.fail("Velocity", "and `Motion` both say how the obstacle moves. Give one of them.");
      motion.angular_velocity = in.text("Angular velocity");
      check_only_time<dim>(in, "Angular velocity");
      check_expression<dim>(
        in, "Angular velocity", motion.angular_velocity, {dealii::Point<dim>()}, "t");
      const bool turns = constant_value(motion.angular_velocity) != 0.;
      if (!turns)
        {
          dealii::ParameterHandler declared;
          declare_obstacle_motion<dim>(declared);
          for (const char *key : {"Rotation centre", "Rotation axis"})
            if (dim == 3 || key != std::string("Rotation axis"))
              refuse_without_effect(in, key, declared, "obstacles that turn", "Angular velocity");
        }
      motion.centre = in.point<dim>("Rotation centre");
      if constexpr (dim == 3)
        {
          motion.axis = in.direction<dim>("Rotation axis");
          motion.axis /= motion.axis.norm();
        }
      if (!is_given(motion.displacement) && !is_given(motion.velocity) && !turns)
        return nullptr;
      motion.panel = panel_of_rates(time);
      return std::make_shared<ObstacleMotion<dim>>(name, motion);
    }
  } // namespace


  template <int dim>
  void declare_obstacle(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    declare_kinds(prm, "Shape", obstacle_shapes<dim>());
    prm.declare_entry(
      "Point",
      (dim == 2 ? "0, 0" : "0, 0, 0"),
      List(Double(), dim, dim),
      "Plane: a point of its surface, with `Extent` the middle of it; cylinder: a point "
      "of its axis (length).");
    for (const ObstacleShape<dim> &shape : obstacle_shapes<dim>())
      shape.declare(prm);
    declare_obstacle_motion<dim>(prm);
  }


  template <int dim>
  NamedObstacle<dim>
  parse_obstacle(const SectionReader &in, const std::string &name, const TimeParameters &time)
  {
    if (!in.given())
      in.fail("",
              "`Obstacles/Names` lists this obstacle, but it has no subsection. Add `subsection "
                + name + " ... end` in section Obstacles, or remove the name from the list.");
    dealii::ParameterHandler declared;
    declare_obstacle<dim>(declared);
    const auto &shape =
      kind_of(in, "Shape", obstacle_shapes<dim>(), declared, [](const auto &owners) {
        return "the shape " + names_of_kinds(owners);
      });
    return {name, shape.parse(in, name), parse_obstacle_motion<dim>(in, name, time)};
  }


#define INSTANTIATE(dim)                                                                           \
  template void               declare_obstacle<dim>(dealii::ParameterHandler &);                   \
  template NamedObstacle<dim> parse_obstacle<dim>(                                                 \
    const SectionReader &, const std::string &, const TimeParameters &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
