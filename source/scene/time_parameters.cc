// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    constexpr double max_steps = 1e8;

    /** Of all schemes, for the description of the key. */
    std::string summaries()
    {
      std::string text;
      for (const SchemeInfo &info : scheme_table())
        text += " " + info.name + ": " + info.summary + ".";
      return text;
    }
  } // namespace


  unsigned int TimeParameters::n_steps() const
  {
    return static_cast<unsigned int>(std::max(1., std::round(end_time / step_size)));
  }


  void declare_time(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Scheme",
                      scheme_table().front().name,
                      Selection(join(scheme_names(), "|")),
                      "Time discretisation." + summaries());
    declare_scheme_parameters(prm);
    prm.declare_entry("Start",
                      name_of(StartKind::given),
                      choices_of<StartKind>(),
                      "How the run begins. given: with the initial displacement of the bodies. "
                      "equilibrium: with the static equilibrium under the loads and the contact of "
                      "time 0; rigid motions that nothing holds stay free. The initial velocity "
                      "counts in both.");
    prm.declare_entry("Step size",
                      "0",
                      Double(),
                      "Length of a time step, in units of time; without inertia that of a load "
                      "step. Must be given.");
    prm.declare_entry("End time",
                      "0",
                      Double(),
                      "The run ends here, in units of time; with fixed steps after End time / Step "
                      "size of them (rounded to the nearest integer). Must be given.");
    prm.declare_entry(
      "Stop on warning",
      "false",
      Bool(),
      "End the run, with exit status 1 and its last state written, at the step with "
      "which the result begins to be doubtful: a body that turns by more than 3 "
      "degrees, is strained by more than 5 %, is deeper in an obstacle than 1 % of "
      "its size, slides along another by more than a face, overlaps what is not its partner, or "
      "has contact nodes whose velocities alternate from step to step.");
    declare_step_sizes(prm);
  }


  TimeParameters parse_time(const SectionReader &in)
  {
    TimeParameters time;
    time.scheme = in.text("Scheme");
    parse_scheme_parameters(in, time);
    time.start           = in.choice<StartKind>("Start");
    time.stop_on_warning = in.flag("Stop on warning");
    for (const std::string key : {"Step size", "End time"})
      if (!in.given(key))
        in.fail(key, "is missing. Give a positive number, in units of time.");
    time.step_size =
      in.positive_number("Step size", "the run goes forward in time; give a number > 0");
    time.end_time = in.positive_number("End time", "the run starts at time 0; give a number > 0");

    if (time.step_size > time.end_time)
      in.fail("Step size",
              "is larger than the end time " + in.text("End time")
                + ". Reduce the step size or increase `End time`.");
    if (time.end_time / time.step_size > max_steps)
      in.fail("Step size",
              "needs more than a hundred million steps until the end time " + in.text("End time")
                + ". Increase the step size or reduce `End time`.");
    return time;
  }
} // namespace signorini
