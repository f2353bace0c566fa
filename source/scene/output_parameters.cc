// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  void declare_output(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry("VTU", "true", Bool(), "Write fields for ParaView or VisIt at all.");
    prm.declare_entry("VTU every",
                      "0",
                      Integer(),
                      "Write fields every so many steps; 0: as often as `VTU states` says.");
    prm.declare_entry("VTU states",
                      "20",
                      Integer(),
                      "Without `VTU every`: write fields of so many states, evenly spread over the "
                      "time of the run, besides the initial one; 1: of the last one only.");
    prm.declare_entry("History every",
                      "1",
                      Integer(),
                      "Write a row of history.csv and of the probes every so many steps.");
  }

  OutputParameters parse_output(const SectionReader &in)
  {
    OutputParameters output;
    output.vtu           = in.flag("VTU");
    output.vtu_every     = in.integer("VTU every", 0, SectionReader::unlimited);
    output.vtu_states    = in.integer("VTU states", 1, SectionReader::unlimited);
    output.history_every = in.integer("History every", 1, SectionReader::unlimited);
    return output;
  }
} // namespace signorini
