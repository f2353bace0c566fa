// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/scene/sections.h>
#include <signorini/schemes/scheme_table.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <optional>

namespace signorini
{
  namespace
  {
    const std::string coefficient_key = "Friction coefficient", bound_key = "Friction bound";

    std::string names_of_schemes_with_friction()
    {
      return join(schemes_where([](const SchemeInfo &info) { return info.friction; }));
    }

    /**
     * Refuse an expression that is wrong, or a negative constant. @return whether it is the
     * constant 0
     */
    template <int dim>
    bool check_and_see_if_zero(const SectionReader                   &in,
                               const std::string                     &key,
                               const std::vector<dealii::Point<dim>> &points,
                               const std::string                     &remedy)
    {
      const std::optional<double> constant = constant_value(in.text(key));
      if (!constant)
        check_expression<dim>(in, key, in.text(key), points, "");
      else if (!std::isfinite(*constant))
        in.fail(key, "must be a finite number. " + remedy);
      else if (*constant < 0.)
        in.fail(key, "must not be negative: friction does not push. " + remedy);
      return constant == 0.;
    }

    template <int dim>
    FrictionDescription parse_coulomb(const SectionReader                   &in,
                                      const std::vector<dealii::Point<dim>> &points)
    {
      FrictionDescription friction;
      friction.coefficient = in.text(coefficient_key);
      friction.bound       = in.text(bound_key);
      friction.any         = !check_and_see_if_zero(
        in, coefficient_key, points, "Give a positive number, or 0 for no friction.");
      if (friction.bound.empty())
        return friction;
      if (!in.given(coefficient_key))
        in.fail(bound_key,
                "limits the friction that `Friction coefficient` gives, but that is not given. Add "
                "it, or set `Friction law = tresca` for a bound that does not depend on the "
                "pressure.");
      if (check_and_see_if_zero(
            in, bound_key, points, "Give a positive stress, or remove this key."))
        in.fail(bound_key,
                "leaves no friction at all, whatever `Friction coefficient` says. Give a positive "
                "stress or remove this key; without friction, set `Friction coefficient = 0`.");
      return friction;
    }

    template <int dim>
    FrictionDescription parse_tresca(const SectionReader                   &in,
                                     const std::vector<dealii::Point<dim>> &points)
    {
      if (in.text(bound_key).empty())
        in.fail(
          bound_key,
          "is the largest tangential stress, which `Friction law = tresca` needs. Give it, or set "
          "`Friction law = coulomb`.");
      if (constant_value(in.text(coefficient_key)) != 0.)
        in.fail(coefficient_key,
                "is not used by `Friction law = tresca`, whose bound does not depend on the "
                "pressure. Remove this key, or set `Friction law = coulomb`; there `Friction "
                "bound` limits the friction.");
      FrictionDescription friction;
      friction.law   = FrictionKind::tresca;
      friction.bound = in.text(bound_key);
      friction.any   = !check_and_see_if_zero(
        in, bound_key, points, "Give a positive stress, or 0 for no friction.");
      return friction;
    }
  } // namespace

  void declare_friction(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry(
      "Friction law",
      name_of(FrictionKind::coulomb),
      choices_of<FrictionKind>(),
      "What the tangential stress can reach before the surfaces slide. coulomb: the coefficient of "
      "friction times the pressure, at most the bound if there is one. tresca: the bound, in steps "
      "that begin with the node in contact.");
    prm.declare_entry("Friction coefficient",
                      "0",
                      Anything(),
                      "coulomb: coefficient of friction (no unit), an expression in x, y, z of the "
                      "undeformed body. Friction is known to the schemes "
                        + names_of_schemes_with_friction() + ".");
    prm.declare_entry("Friction bound",
                      "",
                      Anything(),
                      "Largest tangential stress (force per area), an expression in x, y, z of the "
                      "undeformed body; tresca needs it. Empty: none.");
  }

  template <int dim>
  FrictionDescription parse_friction(const SectionReader                   &in,
                                     const std::string                     &scheme,
                                     const std::vector<dealii::Point<dim>> &points)
  {
    const bool tresca = in.choice<FrictionKind>("Friction law") == FrictionKind::tresca;
    const FrictionDescription friction =
      tresca ? parse_tresca<dim>(in, points) : parse_coulomb<dim>(in, points);
    if (friction.any && !scheme_info(scheme).friction)
      {
        const std::string &key = tresca ? bound_key : coefficient_key;
        in.fail(key,
                "the scheme " + scheme + " knows no friction. Set `" + key
                  + " = 0`, or set `Time/Scheme` to one of " + names_of_schemes_with_friction()
                  + ".");
      }
    return friction;
  }

  template FrictionDescription
  parse_friction(const SectionReader &, const std::string &, const std::vector<dealii::Point<2>> &);
  template FrictionDescription
  parse_friction(const SectionReader &, const std::string &, const std::vector<dealii::Point<3>> &);
} // namespace signorini
