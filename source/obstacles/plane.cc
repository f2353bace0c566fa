// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/plane.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  template <int dim>
  Plane<dim>::Plane(const dealii::Point<dim> &point, const dealii::Tensor<1, dim> &normal)
    : point(point)
    , normal(normal / normal.norm())
  {
  }


  template <int dim>
  ObstacleProjection<dim> Plane<dim>::project(const dealii::Point<dim> &p) const
  {
    return {(p - point) * normal, -normal};
  }


  template <int dim>
  void declare_plane(dealii::ParameterHandler &prm)
  {
    prm.declare_entry(
      "Normal",
      (dim == 2 ? "0, 1" : "0, 0, 1"),
      dealii::Patterns::List(dealii::Patterns::Double(), dim, dim),
      "Plane: points out of the obstacle, towards the bodies; any length but zero.");
  }


  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_plane(const SectionReader &in,
                                                        const std::string &)
  {
    return std::make_shared<Plane<dim>>(in.point<dim>("Point"), in.direction<dim>("Normal"));
  }


#define INSTANTIATE(dim)                                                                           \
  template class Plane<dim>;                                                                       \
  template void declare_plane<dim>(dealii::ParameterHandler &);                                    \
                                                                                                   \
  template std::shared_ptr<const RigidObstacle<dim>> parse_plane(const SectionReader &,            \
                                                                 const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
