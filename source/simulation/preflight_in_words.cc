// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/json.h>
#include <signorini/simulation/preflight.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  namespace
  {
    std::string in_units_of_memory(const double bytes)
    {
      std::ostringstream text;
      text.precision(3);
      if (bytes < 1e9)
        text << std::round(bytes / 1e6) << " MB";
      else
        text << bytes / 1e9 << " GB";
      return text.str();
    }


    void write_memory(const Preflight &preflight, std::ostream &out)
    {
      const MemoryEstimate &memory = preflight.memory;
      out << "  memory            about " << in_units_of_memory(memory.run);
      if (preflight.n_processes > 1)
        out << ", at most " << in_units_of_memory(memory.largest_process) << " in one process";
      if (!std::isfinite(memory.at_most))
        out << " on the first mesh; `Adaptivity/Maximum cells` sets no limit";
      else if (memory.at_most > memory.run)
        out << " on the first mesh, " << in_units_of_memory(memory.at_most)
            << " with `Adaptivity/Maximum cells`";
      out << '\n';
    }


    void write_body(const BodyForecast &body, const double step_size, std::ostream &out)
    {
      out << "  waves in " << body.name << ": speeds " << body.pressure_wave_speed << " and "
          << body.shear_wave_speed << ", transit " << body.transit_time << " ("
          << body.transit_time / step_size << " steps), longitudinal vibration "
          << body.vibration_period << " (" << body.vibration_period / step_size << " steps)\n";
    }


    void write_impact(const ImpactForecast &impact, const double step_size, std::ostream &out)
    {
      const FirstImpact &first = impact.first;
      out << "  first touch of '" << impact.pair << "': time " << first.time << ", speed "
          << first.speed;
      if (!first.is_known)
        out << "; no theory tells how long it lasts (a wave is back after " << first.wave_transit
            << ", " << first.wave_transit / step_size << " steps)\n";
      else
        {
          out << ", contact for " << first.impact.duration << " (" << impact.n_steps
              << " steps); recommended step " << impact.recommended_step_size;
          if (impact.recommended_node_spacing > 0.)
            out << ", distance of nodes " << impact.recommended_node_spacing << " instead of "
                << first.node_spacing;
          out << '\n';
        }
    }


    std::string json_of(const BodyForecast &body, const double step_size)
    {
      return JsonObject()
        .text("name", body.name)
        .number("pressure_wave_speed", body.pressure_wave_speed)
        .number("shear_wave_speed", body.shear_wave_speed)
        .number("transit_time", body.transit_time)
        .number("steps_per_transit", body.transit_time / step_size)
        .number("vibration_period", body.vibration_period)
        .number("steps_per_vibration", body.vibration_period / step_size)
        .line();
    }


    std::string json_of(const ImpactForecast &impact)
    {
      const FirstImpact &first = impact.first;
      JsonObject         object;
      object.text("pair", impact.pair)
        .number("time", first.time)
        .number("speed", first.speed)
        .text("theory",
              !first.is_known  ? "none"
              : first.is_round ? "Hertz"
                               : "plane wave");
      if (first.is_known)
        object.number("force", first.impact.force)
          .number("duration", first.impact.duration)
          .number("steps", impact.n_steps)
          .number("nodes", first.impact.n_nodes)
          .number("strain", first.impact.strain)
          .number("node_spacing", first.node_spacing)
          .number("recommended_step_size", impact.recommended_step_size)
          .number("recommended_node_spacing",
                  impact.recommended_node_spacing > 0. ? impact.recommended_node_spacing : NAN);
      else
        object.number("wave_transit", first.wave_transit);
      return object.line();
    }
  } // namespace


  std::string in_words(const Preflight &preflight)
  {
    std::ostringstream out;
    out.precision(4);
    out << "  law               " << preflight.law << '\n';
    write_memory(preflight, out);
    if (preflight.has_inertia)
      for (const BodyForecast &body : preflight.bodies)
        write_body(body, preflight.step_size, out);
    for (const ImpactForecast &impact : preflight.impacts)
      write_impact(impact, preflight.step_size, out);
    if (preflight.has_inertia)
      out << "  step size         " << preflight.step_size << ", recommended "
          << preflight.recommended_step_size << '\n';
    for (const std::string &clause : preflight.skipped)
      out << "  skipped           " << clause << '\n';
    for (const std::string &warning : preflight.warnings)
      out << "  warning: " << warning << '\n';
    return out.str();
  }


  std::string as_json(const Preflight &preflight)
  {
    std::vector<std::string> bodies, impacts;
    for (const BodyForecast &body : preflight.bodies)
      bodies.push_back(json_of(body, preflight.step_size));
    for (const ImpactForecast &impact : preflight.impacts)
      impacts.push_back(json_of(impact));
    JsonObject object;
    object.text("scene", preflight.scene)
      .number("dimension", preflight.dimension)
      .number("processes", preflight.n_processes)
      .text("scheme", preflight.scheme)
      .text("law", preflight.law)
      .number("step_size", preflight.step_size)
      .truth("variable_steps", preflight.variable_steps)
      .number("end_time", preflight.end_time)
      .number("steps", preflight.n_steps)
      .number("cells", preflight.cells)
      .number("dofs", preflight.dofs)
      .number("contact_nodes", preflight.contact_nodes)
      .number("courant_number", preflight.has_inertia ? preflight.courant_number : NAN)
      .number("memory_prepared", preflight.memory.prepared)
      .number("memory", preflight.memory.run)
      .number("memory_of_largest_process", preflight.memory.largest_process)
      .number("memory_at_most", preflight.memory.at_most)
      .number("recommended_step_size",
              preflight.has_inertia ? preflight.recommended_step_size : NAN)
      .value_of("bodies", json_list(bodies))
      .value_of("impacts", json_list(impacts))
      .texts("skipped", preflight.skipped)
      .texts("notes", preflight.notes)
      .texts("warnings", preflight.warnings);
    return object.lines() + "\n";
  }
} // namespace signorini
