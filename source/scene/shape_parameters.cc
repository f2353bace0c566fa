// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/model/placed_body.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/prm/kinds_of_section.h>
#include <signorini/scene/sections.h>
#include <signorini/shapes/box_shape.h>
#include <signorini/shapes/shape_table.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  namespace
  {
    // 12 refinements make 8^12 = 7e10 cells of one cell in 3d: a slip of the keyboard rather than
    // an intention.
    constexpr unsigned int max_refinements = 12;

    /** Bodies of these shapes: `balls and cylinders`. */
    template <int dim>
    std::string in_words(const std::vector<const BodyShapeKind<dim> *> &shapes)
    {
      std::vector<std::string> bodies;
      for (const BodyShapeKind<dim> *shape : shapes)
        bodies.emplace_back(shape->plural);
      return enumeration(bodies, " and ");
    }

    void declare_refinement(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      prm.declare_entry(
        "Refinements",
        "0",
        Integer(),
        "Uniform refinements of the coarse mesh; each halves the size of the cells. At most 12.");
      prm.declare_entry(
        "Local refinements",
        "0",
        Integer(),
        "Further refinements of the cells that `Refine where` selects. At most 12.");
      prm.declare_entry(
        "Refine where",
        "",
        Anything(),
        "Expression in x, y, z, the centre of a cell, and h, its size (its diameter over the root "
        "of the dimension, the edge of a cube): positive values select the cell for local "
        "refinement, for example 0.2 - z near the plane z = 0, or 3*h - sqrt(x^2 + y^2 + z^2) for "
        "cells that become smaller and smaller towards the origin.");
    }
  } // namespace

  template <int dim>
  void declare_shape(dealii::ParameterHandler &prm)
  {
    const auto              &shapes = body_shapes<dim>();
    std::vector<std::string> names, summaries;
    for (const BodyShapeKind<dim> &shape : shapes)
      {
        names.emplace_back(shape.name);
        summaries.emplace_back(shape.summary);
      }
    prm.declare_entry("Shape",
                      names.front(),
                      dealii::Patterns::Selection(join(names, "|")),
                      enumeration(summaries, ", or ") + ".");
    for (const BodyShapeKind<dim> &shape : shapes)
      shape.declare(prm);
    declare_cap<dim>(prm);
    declare_placement<dim>(prm);
    declare_refinement(prm);
  }

  template <int dim>
  void parse_shape(const SectionReader &in, BodyDescription<dim> &body)
  {
    dealii::ParameterHandler declared;
    declare_shape<dim>(declared);
    const auto &kind = kind_of(in, "Shape", body_shapes<dim>(), declared, in_words<dim>);
    body.shape_name  = kind.name;
    body.shape       = kind.parse(in);
    body.placement   = parse_placement(in, body);

    body.refinements       = in.integer("Refinements", 0, max_refinements);
    body.local_refinements = in.integer("Local refinements", 0, max_refinements);
    body.refine_where      = in.text("Refine where");
    if (body.local_refinements > 0 && body.refine_where.empty())
      in.fail("Local refinements",
              "`Refine where` does not say which cells to refine. Give it an expression such as "
              "0.2 - z, or use `Refinements`.");
    if (!body.refine_where.empty())
      check_expression<dim>(in, "Refine where", body.refine_where, {centre_of(body)}, "h");
    if (!body.refine_where.empty() && !in.given("Local refinements"))
      in.fail("Refine where",
              "selects cells, but `Local refinements` does not say how often to refine them. Give "
              "it a number, or remove this key.");
  }

  template void declare_shape<2>(dealii::ParameterHandler &);
  template void declare_shape<3>(dealii::ParameterHandler &);
  template void parse_shape(const SectionReader &, BodyDescription<2> &);
  template void parse_shape(const SectionReader &, BodyDescription<3> &);
} // namespace signorini
