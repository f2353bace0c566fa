// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/model/placed_body.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    const std::string grammar =
      "Write `id: expression; expression; ...` with one expression per component, `-` for a free "
      "component, and | between the boundaries.";

    /** Split at single |; a || is the logical or of an expression. */
    std::vector<std::string> split_conditions(const std::string &text)
    {
      std::vector<std::string> entries(1);
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '|' && i + 1 < text.size() && text[i + 1] == '|')
          {
            entries.back() += "||";
            ++i;
          }
        else if (text[i] == '|')
          entries.emplace_back();
        else
          entries.back() += text[i];
      return entries;
    }

    template <int dim>
    std::vector<dealii::types::boundary_id> read_boundary_ids(const SectionReader        &in,
                                                              const std::string          &key,
                                                              const std::string          &word,
                                                              const BodyDescription<dim> &body)
    {
      const BodyShape<dim> &shape = *body.shape;
      const auto            ids   = boundary_ids_named(shape, word);
      if (ids.empty())
        in.fail(key,
                (shape.file().empty() ? "a " + body.shape_name : "the mesh " + shape.file())
                  + " has no boundary id `" + word + "`. Valid: " + list_of_boundaries(shape)
                  + ".");
      return ids;
    }

    /** One condition for each boundary id. */
    template <int dim>
    std::vector<BoundaryCondition<dim>> parse_conditions_of(const SectionReader        &in,
                                                            const std::string          &key,
                                                            const std::string          &entry,
                                                            const BodyDescription<dim> &body)
    {
      const std::size_t colon = entry.find(':');
      if (colon == std::string::npos)
        in.fail(key, "`" + trim(entry) + "` does not name a boundary id. " + grammar);
      BoundaryCondition<dim> condition;
      const auto             ids = read_boundary_ids(in, key, trim(entry.substr(0, colon)), body);
      condition.expressions      = split_components<dim>(in, key, trim(entry.substr(colon + 1)));
      for (std::string &expression : condition.expressions)
        if (expression == "-")
          expression.clear();
        else
          for (const dealii::types::boundary_id id : ids)
            check_expression<dim>(in, key, expression, boundary_points(body, id), "t");
      std::vector<BoundaryCondition<dim>> conditions;
      for (const dealii::types::boundary_id id : ids)
        {
          condition.boundary_id = id;
          conditions.push_back(condition);
        }
      return conditions;
    }

    template <int dim>
    std::vector<BoundaryCondition<dim>>
    parse_list(const SectionReader &in, const std::string &key, const BodyDescription<dim> &body)
    {
      std::vector<BoundaryCondition<dim>> conditions;
      if (in.text(key).empty())
        return conditions;
      for (const std::string &entry : split_conditions(in.text(key)))
        for (const auto &condition : parse_conditions_of(in, key, entry, body))
          {
            for (const auto &earlier : conditions)
              if (earlier.boundary_id == condition.boundary_id)
                in.fail(key,
                        "boundary id " + std::to_string(condition.boundary_id)
                          + " is given twice. Join the two entries.");
            conditions.push_back(condition);
          }
      return conditions;
    }

    template <int dim>
    void check_conflicts(const SectionReader &in, const BodyDescription<dim> &body)
    {
      for (const BoundaryCondition<dim> &traction : body.traction)
        for (const BoundaryCondition<dim> &dirichlet : body.dirichlet)
          for (unsigned int d = 0; d < dim; ++d)
            if (traction.boundary_id == dirichlet.boundary_id && !traction.expressions[d].empty()
                && traction.expressions[d] != "0" && !dirichlet.expressions[d].empty())
              in.fail("Traction",
                      std::string("the ") + "xyz"[d] + " component on boundary id "
                        + std::to_string(traction.boundary_id)
                        + " is prescribed as a displacement by `Dirichlet` already. Write - for "
                          "this component in one of the two.");
    }
  } // namespace

  template <int dim>
  void declare_conditions(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Anything;
    const std::string form =
      "`id: expressions` per boundary, separated by |, expressions in x, y, z, t separated by "
      "semicolons; a - leaves a component free; instead of an id the name of a group of faces in a "
      "mesh file. Example: ";
    prm.declare_entry(
      "Dirichlet",
      "",
      Anything(),
      "Prescribed displacement (length) on boundaries: " + form
        + (dim == 2 ? "0: 0; - | 1: 0; 0.1*sin(t)" : "0: 0; -; - | 1: 0; 0; 0.1*sin(t)")
        + ". Where two of these boundaries meet they must agree. The run starts with the velocity "
          "of the condition. A node that an obstacle meets obliquely moves towards it in the free "
          "directions.");
    prm.declare_entry("Traction",
                      "",
                      Anything(),
                      "Surface force (force per area) on boundaries: " + form
                        + (dim == 2 ? "3: 0; -2*t" : "5: 0; 0; -2*t"));
  }

  template <int dim>
  void parse_conditions(const SectionReader &in, BodyDescription<dim> &body)
  {
    body.dirichlet = parse_list(in, "Dirichlet", body);
    body.traction  = parse_list(in, "Traction", body);
    check_conflicts(in, body);
  }

  template void declare_conditions<2>(dealii::ParameterHandler &);
  template void declare_conditions<3>(dealii::ParameterHandler &);
  template void parse_conditions(const SectionReader &, BodyDescription<2> &);
  template void parse_conditions(const SectionReader &, BodyDescription<3> &);
} // namespace signorini
