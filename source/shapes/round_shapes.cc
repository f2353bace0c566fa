// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/shapes/round_shapes.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  template <int dim>
  void declare_round_shapes(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Centre",
                      dim == 2 ? "0, 0" : "0, 0, 0",
                      List(Double(), dim, dim),
                      "Ball, cylinder: the centre (length).");
    prm.declare_entry("Radius", "1", Double(), "Ball, cylinder: the radius (length), > 0.");
    prm.declare_entry(
      "Length", "2", Double(), "Cylinder: distance between bottom and top (length), > 0.");
    prm.declare_entry("Axis", "z", Selection("x|y|z"), "Cylinder: direction of the axis.");
    prm.declare_entry(
      "Axial cells",
      "2",
      Integer(),
      "Cylinder: coarse cells from bottom to top. Those of a slender one are as long "
      "as wide with about 4/3 of its length over its radius.");
  }


  double parse_radius(const SectionReader &in)
  {
    // The meshes of round bodies are made with an absolute tolerance of 1e-10.
    constexpr double smallest = 1e-8;
    const double     radius   = in.positive_number("Radius", "it is a length");
    if (radius < smallest)
      in.fail("Radius",
              "is smaller than 1e-8, for which no mesh can be made. Choose a larger unit of "
              "length, for the other quantities, too.");
    return radius;
  }


  template <int dim>
  std::vector<dealii::Point<dim>>
  poles(const dealii::Point<dim> &centre, const double radius, const unsigned int axis)
  {
    std::vector<dealii::Point<dim>> points;
    for (unsigned int d = 0; d < dim; ++d)
      for (const double side : {-1., 1.})
        if (d != axis)
          {
            points.push_back(centre);
            points.back()[d] += side * radius;
          }
    return points;
  }


#define INSTANTIATE(dim)                                                                           \
  template void                            declare_round_shapes<dim>(dealii::ParameterHandler &);  \
  template std::vector<dealii::Point<dim>> poles(const dealii::Point<dim> &, double, unsigned int)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
