// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/json.h>
#include <signorini/schemes/alpha_rule.h>
#include <signorini/schemes/scheme_table.h>

#include <ostream>

namespace signorini
{
  namespace
  {
    std::string yes_or_no(const bool yes)
    {
      return yes ? "yes" : "no";
    }

    /** "middle", "end", or how far before the end. */
    std::string instant(const SchemeInfo &info)
    {
      if (info.force_before_end == "0")
        return "end";
      if (info.force_before_end == "0.5")
        return "middle";
      return info.force_before_end + " before the end, p = `" + info.parameter + "`";
    }
  } // namespace


  void print_schemes(std::ostream &out)
  {
    out
      << "| scheme | energy at contact | friction | massless contact nodes | predictor | contact "
         "force belongs to | penetrates | changing mesh | variable step | contact may follow | in "
         "one sentence |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const SchemeInfo &info : scheme_table())
      out << "| `" << info.name << "` | " << name_of(info.energy) << " | "
          << yes_or_no(info.friction) << " | " << name_of(info.massless) << " | "
          << yes_or_no(info.predictor) << " | " << instant(info) << " | "
          << yes_or_no(info.penetrates) << " | " << yes_or_no(info.changing_mesh) << " | "
          << yes_or_no(info.variable_step()) << " | " << yes_or_no(info.moving_contact) << " | "
          << info.summary << " |\n";
  }


  void print_schemes_as_json(std::ostream &out)
  {
    const auto  truth     = [](const bool value) { return value ? "true" : "false"; };
    const char *separator = "[\n";
    for (const SchemeInfo &info : scheme_table())
      {
        out << separator << "  {\"name\": " << json_text(info.name)
            << ", \"summary\": " << json_text(info.summary)
            << ",\n   \"energy\": " << json_text(name_of(info.energy))
            << ", \"friction\": " << truth(info.friction)
            << ", \"massless_nodes\": " << json_text(name_of(info.massless))
            << ", \"predictor\": " << truth(info.predictor)
            << ",\n   \"force_before_end\": " << json_text(info.force_before_end)
            << ", \"parameter\": " << json_text(info.parameter)
            << ", \"automatic\": " << AlphaRule::usual_radius
            << ", \"mean_velocity\": " << truth(info.mean_velocity)
            << ", \"penetrates\": " << truth(info.penetrates)
            << ",\n   \"changing_mesh\": " << truth(info.changing_mesh)
            << ", \"variable_step\": " << truth(info.variable_step())
            << ", \"moving_contact\": " << truth(info.moving_contact)
            << ", \"inertia\": " << truth(info.inertia) << "}";
        separator = ",\n";
      }
    out << "\n]\n";
  }
} // namespace signorini
