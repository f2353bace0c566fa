// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/round_obstacle.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  RoundObstacle<dim>::RoundObstacle(const Point<dim>     &centre,
                                    const Tensor<1, dim> &axis,
                                    const double          radius,
                                    const bool            bodies_inside)
    : centre(centre)
    , axis(axis.norm() > 0. ? axis / axis.norm() : axis)
    , radius(radius)
    , sign(bodies_inside ? -1. : 1.)
  {
  }


  template <int dim>
  Tensor<1, dim> RoundObstacle<dim>::arm(const Point<dim> &p) const
  {
    const Tensor<1, dim> away = p - centre;
    return away - (away * axis) * axis;
  }


  template <int dim>
  ObstacleProjection<dim> RoundObstacle<dim>::project(const Point<dim> &p) const
  {
    const Tensor<1, dim> away     = arm(p);
    const double         distance = away.norm();
    if (distance == 0.) // the centre: every direction is right
      {
        Tensor<1, dim> any;
        any[dim - 1] = 1.;
        any -= (any * axis) * axis;
        if (any.norm() < 0.5)
          {
            any    = Tensor<1, dim>();
            any[0] = 1.;
            any -= (any * axis) * axis;
          }
        return {-sign * radius, any / any.norm()};
      }
    return {sign * (distance - radius), -sign / distance * away};
  }


  template <int dim>
  MotionCondition<dim> RoundObstacle<dim>::condition_of_motion(const Point<dim> &start,
                                                               const Point<dim> &end) const
  {
    const ObstacleProjection<dim> before = project(start);
    const Tensor<1, dim>          first = arm(start), second = arm(end);
    // -(|second| - |first|) = normal.(second - first)
    const Tensor<1, dim> normal = -sign / (first.norm() + second.norm()) * (first + second);
    const double         size   = normal.norm();
    // Past the centre there is no such thing as a way round: the tangent plane at the start holds.
    if (!(size > 0.1))
      return {before.normal, before.gap, 1., false};
    return {normal / size, before.gap / size, size};
  }


  namespace
  {
    void declare_round(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Radius", "1", Patterns::Double(), "Sphere, cylinder: the radius (length), > 0.");
      prm.declare_entry(
        "Bodies inside",
        "false",
        Patterns::Bool(),
        "Sphere, cylinder, mesh: the obstacle is hollow and the bodies are inside of it; of a mesh "
        "with an end, the bodies are on its other side.");
    }

    double parse_radius(const SectionReader &in)
    {
      return in.positive_number("Radius", "it is a length");
    }
  } // namespace


  template <int dim>
  void declare_sphere(ParameterHandler &prm)
  {
    prm.declare_entry("Centre",
                      (dim == 2 ? "0, 0" : "0, 0, 0"),
                      Patterns::List(Patterns::Double(), dim, dim),
                      "Sphere: the centre (length).");
    declare_round(prm);
  }


  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_sphere(const SectionReader &in,
                                                         const std::string &)
  {
    return std::make_shared<RoundObstacle<dim>>(
      in.point<dim>("Centre"), Tensor<1, dim>(), parse_radius(in), in.flag("Bodies inside"));
  }


  template <int dim>
  void declare_cylinder(ParameterHandler &prm)
  {
    declare_round(prm);
    prm.declare_entry("Axis",
                      (dim == 2 ? "0, 1" : "0, 0, 1"),
                      Patterns::List(Patterns::Double(), dim, dim),
                      "Cylinder: direction of the axis; any length but zero.");
  }


  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_cylinder(const SectionReader &in,
                                                           const std::string &)
  {
    if (dim == 2)
      in.fail("Shape", "a cylinder exists in 3d only. In 2d use `sphere`, which is a circle.");
    return std::make_shared<RoundObstacle<dim>>(in.point<dim>("Point"),
                                                in.direction<dim>("Axis"),
                                                parse_radius(in),
                                                in.flag("Bodies inside"));
  }


#define INSTANTIATE(dim)                                                                           \
  template class RoundObstacle<dim>;                                                               \
  template void                                      declare_sphere<dim>(ParameterHandler &);      \
  template std::shared_ptr<const RigidObstacle<dim>> parse_sphere(const SectionReader &,           \
                                                                  const std::string &);            \
  template void                                      declare_cylinder<dim>(ParameterHandler &);    \
  template std::shared_ptr<const RigidObstacle<dim>> parse_cylinder(const SectionReader &,         \
                                                                    const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
