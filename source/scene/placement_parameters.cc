// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/model/placed_body.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  template <int dim>
  void declare_placement(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const std::string zero = (dim == 2 ? "0, 0" : "0, 0, 0");
    if (dim == 2)
      prm.declare_entry("Rotation",
                        "0",
                        Double(),
                        "Angle in degrees, counter-clockwise, by which the shape is rotated. "
                        "Boundary ids are those of the shape before.");
    else
      prm.declare_entry("Rotation",
                        zero,
                        List(Double(), dim, dim),
                        "Angles in degrees by which the shape is rotated: about the x axis first, "
                        "then about the y axis, then about the z axis (axes of space, not of the "
                        "body). Boundary ids are those of the shape before. Expressions are not "
                        "rotated.");
    prm.declare_entry(
      "Rotation centre",
      "",
      List(Double(), 0, dim),
      "The point (length) that the rotation leaves in place. Empty: the centre of the shape.");
    prm.declare_entry("Translation",
                      zero,
                      List(Double(), dim, dim),
                      "Vector (length) by which the shape is moved after the rotation.");
  }

  template <int dim>
  Placement<dim> parse_placement(const SectionReader &in, const BodyDescription<dim> &body)
  {
    const std::string  list   = in.text("Rotation centre");
    dealii::Point<dim> centre = body.shape->midpoint();
    if (!list.empty() && split(list, ',').size() != dim)
      in.fail("Rotation centre",
              "must be " + std::to_string(dim)
                + " numbers (one per space dimension), separated by commas, or nothing for the "
                  "centre of the shape.");
    if (!list.empty())
      centre = in.point<dim>("Rotation centre");
    return Placement<dim>(in.angles<dim>("Rotation"), centre, in.point<dim>("Translation"));
  }

#define INSTANTIATE(dim)                                                                           \
  template void           declare_placement<dim>(dealii::ParameterHandler &);                      \
  template Placement<dim> parse_placement(const SectionReader &, const BodyDescription<dim> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
