// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include "parts.h"

#include <signorini/obstacles/obstacle_table.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace
{
  using namespace signorini;

  /** A row of half cylinders across x, side by side; its tops are at the height 0. */
  template <int dim>
  class Washboard : public RigidObstacle<dim>
  {
  public:
    explicit Washboard(const double radius)
      : radius(radius)
    {
    }

    ObstacleProjection<dim> project(const dealii::Point<dim> &point) const override
    {
      dealii::Tensor<1, dim> away; // from the axis of the nearest ridge
      away[0]               = point[0] - 2. * radius * std::round(point[0] / (2. * radius));
      away[dim - 1]         = point[dim - 1] + radius;
      const double distance = away.norm();
      return {distance - radius, -away / distance};
    }

  private:
    const double radius;
  };


  void declare(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Ridge radius",
                      "0.1",
                      dealii::Patterns::Double(),
                      "Washboard: radius of its ridges (length), > 0.");
  }


  template <int dim>
  std::shared_ptr<const RigidObstacle<dim>> parse(const SectionReader &in, const std::string &)
  {
    return std::make_shared<Washboard<dim>>(in.positive_number("Ridge radius", "it is a length"));
  }


  template <int dim>
  void add()
  {
    add_obstacle_shape<dim>({"washboard",
                             "washboard (a floor with round ridges)",
                             declare,
                             {"Ridge radius"},
                             parse<dim>});
  }
} // namespace


void add_washboard()
{
  add<2>();
  add<3>();
}
