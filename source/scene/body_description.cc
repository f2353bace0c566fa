// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/model/placed_body.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  namespace
  {
    template <int dim>
    std::string zero_vector()
    {
      return dim == 2 ? "0; 0" : "0; 0; 0";
    }
  } // namespace

  template <int dim>
  void declare_body(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Anything;
    declare_shape<dim>(prm);
    declare_material(prm);
    prm.declare_entry(
      "Element",
      name_of(ElementKind::enhanced),
      choices_of<ElementKind>(),
      "What strain a cell has. standard: that of its (bi-, tri-)linear displacement; "
      "too stiff in bending, and if Poisson's ratio is close to 0.5. enhanced: also "
      "that of incompatible modes, eliminated cell by cell, which cure both at no "
      "cost per step. mean dilatation: one change of volume per cell, which cures "
      "the latter only; for comparison. See doc/elements.md.");
    prm.declare_entry("Initial displacement",
                      zero_vector<dim>(),
                      Anything(),
                      "Displacement at time 0 (length): one expression in x, y, z per component, "
                      "separated by semicolons.");
    prm.declare_entry(
      "Initial velocity",
      zero_vector<dim>(),
      Anything(),
      "Velocity at time 0 (length per time): expressions in x, y, z, separated by semicolons.");
    prm.declare_entry("Body force",
                      zero_vector<dim>(),
                      Anything(),
                      "Force per mass, that is, an acceleration such as gravity (length per time "
                      "squared): expressions in x, y, z, t, separated by semicolons.");
    declare_conditions<dim>(prm);
  }

  template <int dim>
  BodyDescription<dim> parse_body(const SectionReader &in, const std::string &name)
  {
    if (!in.given())
      in.fail("",
              "`Bodies/Names` lists this body, but it has no subsection. Add `subsection " + name
                + " ... end` in section Bodies, or remove the name from the list.");
    BodyDescription<dim> body;
    body.name = name;
    parse_shape(in, body);
    body.material = parse_material(in);
    body.element  = in.choice<ElementKind>("Element");

    const auto points         = sample_points(body);
    body.initial_displacement = read_expressions<dim>(in, "Initial displacement", points, false);
    body.initial_velocity     = read_expressions<dim>(in, "Initial velocity", points, false);
    body.body_force           = read_expressions<dim>(in, "Body force", points, true);
    parse_conditions(in, body);
    return body;
  }

#define INSTANTIATE(dim)                                                                           \
  template void                 declare_body<dim>(dealii::ParameterHandler &);                     \
  template BodyDescription<dim> parse_body<dim>(const SectionReader &, const std::string &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
