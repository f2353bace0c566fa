// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include "parts.h"

#include <signorini/materials/material_table.h>

#include <deal.II/base/parameter_handler.h>

#include <map>

namespace
{
  using namespace signorini;

  /** Typical constants in Pa, without unit, and kg/m^3. */
  const std::map<std::string, Material> alloys = {{"steel", {210e9, 0.3, 7850.}},
                                                  {"aluminium", {70e9, 0.33, 2700.}},
                                                  {"brass", {100e9, 0.35, 8500.}}};


  void declare(dealii::ParameterHandler &prm)
  {
    std::string names;
    for (const auto &[name, constants] : alloys)
      names += (names.empty() ? "" : "|") + name;
    prm.declare_entry("Alloy",
                      "steel",
                      dealii::Patterns::Selection(names),
                      "Alloy: its name; typical constants in SI units.");
  }


  Material parse(const SectionReader &in)
  {
    return alloys.at(in.text("Alloy"));
  }
} // namespace


void add_alloy()
{
  add_material_model({"alloy", "alloy (constants by name, SI units)", declare, {"Alloy"}, parse});
}
