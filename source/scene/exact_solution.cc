// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/model/placed_body.h>
#include <signorini/prm/check_expressions.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  template <int dim>
  void declare_exact_solution(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Anything;
    prm.declare_entry("Displacement",
                      "",
                      Anything(),
                      "Exact displacement (length), to be compared with: expressions in x, y, z, "
                      "t, separated by semicolons. Empty: not known.");
    prm.declare_entry(
      "Velocity",
      "",
      Anything(),
      "Exact velocity (length per time): expressions in x, y, z, t, separated by semicolons.");
  }

  template <int dim>
  ExactSolutionDescription<dim>
  parse_exact_solution(const SectionReader &in, const std::vector<BodyDescription<dim>> &bodies)
  {
    ExactSolutionDescription<dim> exact;
    const bool                    has_displacement = !in.text("Displacement").empty();
    const bool                    has_velocity     = !in.text("Velocity").empty();
    if (has_displacement != has_velocity)
      in.fail(
        has_displacement ? "Velocity" : "Displacement",
        "displacement and velocity of an exact solution are used together. Give both or none.");
    exact.given = has_displacement;
    if (!exact.given)
      return exact;

    std::vector<dealii::Point<dim>> points;
    for (const BodyDescription<dim> &body : bodies)
      for (const dealii::Point<dim> &point : sample_points(body))
        points.push_back(point);
    exact.displacement = read_expressions<dim>(in, "Displacement", points, true);
    exact.velocity     = read_expressions<dim>(in, "Velocity", points, true);
    return exact;
  }

#define INSTANTIATE(dim)                                                                           \
  template void                          declare_exact_solution<dim>(dealii::ParameterHandler &);  \
  template ExactSolutionDescription<dim> parse_exact_solution(                                     \
    const SectionReader &, const std::vector<BodyDescription<dim>> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
