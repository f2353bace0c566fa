// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  template <int dim>
  void declare_probe(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Point",
                      dim == 2 ? "0, 0" : "0, 0, 0",
                      List(Double(), dim, dim),
                      "The probe is the node of a contact surface that is closest to this point of "
                      "the undeformed body (length).");
  }

  template <int dim>
  ProbeDescription<dim> parse_probe(const SectionReader &in, const std::string &name)
  {
    if (!in.given("Point"))
      in.fail(
        "Point",
        "the probe `" + name + "` has no place. Add `subsection " + name
          + "` with `set Point = ...` in section Probes, or remove the name from `Probes/Names`.");
    return {name, in.point<dim>("Point")};
  }

  template void                declare_probe<2>(dealii::ParameterHandler &);
  template void                declare_probe<3>(dealii::ParameterHandler &);
  template ProbeDescription<2> parse_probe<2>(const SectionReader &, const std::string &);
  template ProbeDescription<3> parse_probe<3>(const SectionReader &, const std::string &);
} // namespace signorini
