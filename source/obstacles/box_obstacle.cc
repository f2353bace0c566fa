// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/box_obstacle.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  BoxObstacle<dim>::BoxObstacle(const Point<dim> &lower, const Point<dim> &upper)
    : lower(lower)
    , upper(upper)
  {
  }


  template <int dim>
  ObstacleProjection<dim> BoxObstacle<dim>::project(const Point<dim> &p) const
  {
    double         highest = -std::numeric_limits<double>::infinity(); // above a face, outwards
    Tensor<1, dim> out, away;
    for (unsigned int c = 0; c < dim; ++c)
      for (const double side : {-1., 1.})
        {
          const double height = side > 0. ? p[c] - upper[c] : lower[c] - p[c];
          if (height > 0.)
            away[c] = side * height;
          if (height > highest)
            {
              highest = height;
              out     = Tensor<1, dim>();
              out[c]  = side;
            }
        }
    if (const double distance = away.norm(); highest > 0. && distance > highest) // beside an edge
      return {distance, -1. / distance * away};
    return {highest, -out};
  }


  template <int dim>
  void declare_box(ParameterHandler &prm)
  {
    const auto corner = [](const std::string &coordinate) {
      return dim == 2 ? coordinate + ", " + coordinate
                      : coordinate + ", " + coordinate + ", " + coordinate;
    };
    const Patterns::List point(Patterns::Double(), dim, dim);
    prm.declare_entry("Lower corner", corner("0"), point, "Box: smallest coordinates (length).");
    prm.declare_entry("Upper corner", corner("1"), point, "Box: largest coordinates (length).");
  }


  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse_box(const SectionReader &in, const std::string &)
  {
    const auto [lower, upper] = in.corners<dim>();
    return std::make_shared<BoxObstacle<dim>>(lower, upper);
  }


#define INSTANTIATE(dim)                                                                           \
  template class BoxObstacle<dim>;                                                                 \
  template void declare_box<dim>(ParameterHandler &);                                              \
                                                                                                   \
  template std::shared_ptr<const RigidObstacle<dim>> parse_box(const SectionReader &,              \
                                                               const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
