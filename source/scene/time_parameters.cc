// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    constexpr double max_steps = 1e8;
  }

  unsigned int TimeParameters::n_steps() const
  {
    return static_cast<unsigned int>(std::max(1., std::round(end_time / step_size)));
  }

  void declare_time(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry(
      "Scheme",
      "contact-stabilized",
      Selection("newmark|laursen-chawla|laursen-love|contact-implicit|contact-stabilized|"
                "contact-stabilized-projected|hht-alpha|generalized-alpha|"
                "nonsmooth-generalized-alpha|backward-euler|moreau-jean"),
      "Time discretisation. contact-stabilized: Newmark with a predictor that respects the contact "
      "condition; dissipative, smooth contact forces. contact-stabilized-projected: the same, and the "
      "projection acts on the velocity, too; nodes in contact have no normal velocity. contact-implicit: "
      "without a predictor; dissipative, contact forces oscillate. laursen-chawla: conserves energy, "
      "allows penetration. laursen-love: conserves energy by impulses, without penetration. newmark: the "
      "classical scheme with contact; gains energy at impact. hht-alpha, generalized-alpha, "
      "nonsmooth-generalized-alpha, backward-euler, moreau-jean: widely used, for comparison.");
    prm.declare_entry(
      "HHT alpha", "-0.1", Double(), "Damping of hht-alpha, between -1/3 (most) and 0 (none; no unit).");
    prm.declare_entry("Spectral radius",
                      "0.8",
                      Double(),
                      "Of generalized-alpha and nonsmooth-generalized-alpha at infinite frequency, between 0 (most "
                      "damping) and 1 (none; no unit).");
    prm.declare_entry("Mass",
                      "consistent",
                      Selection("consistent|lumped"),
                      "Mass matrix of the time discretisation: consistent (integrated exactly) or lumped "
                      "(diagonal).");
    prm.declare_entry(
      "Predictor mass",
      "consistent",
      Selection("consistent|lumped"),
      "Mass matrix of the projection in the predictor of contact-stabilized. lumped is cheaper "
      "(node by node); with the consistent mass the scheme then loses more energy and is no longer sure "
      "never to gain any. No other scheme uses it.");
    prm.declare_entry(
      "Impulses",
      "common",
      Selection("common|per node"),
      "How laursen-love shares the impulses that give lost energy back. common: along the contact forces, "
      "from one equation. per node: each contact node gets back what it has lost, from coupled equations; "
      "takes more time. No other scheme uses it.");
    prm.declare_entry("Step size", "0", Double(), "Length of a time step, in units of time. Must be given.");
    prm.declare_entry("End time",
                      "0",
                      Double(),
                      "The run ends here, in units of time, after End time / Step size steps (rounded to the "
                      "nearest integer). Must be given.");
  }

  TimeParameters parse_time(const SectionReader &in)
  {
    TimeParameters time;
    time.scheme          = in.text("Scheme");
    time.mass            = in.text("Mass");
    time.predictor       = in.text("Predictor mass");
    time.hht_alpha       = in.number("HHT alpha");
    time.spectral_radius = in.number("Spectral radius");
    time.impulses        = in.text("Impulses");
    if (!(time.hht_alpha >= -1. / 3. && time.hht_alpha <= 0.))
      in.fail("HHT alpha", "must lie between -1/3 and 0. Beyond, the method is not stable or not of second order.");
    if (!(time.spectral_radius >= 0. && time.spectral_radius <= 1.))
      in.fail("Spectral radius", "must lie between 0 and 1. Above 1 the method is not stable.");
    for (const std::string key : {"Step size", "End time"})
      if (!in.given(key))
        in.fail(key, "is missing. Give a positive number, in units of time.");
    time.step_size = in.positive_number("Step size", "the run goes forward in time; give a number > 0");
    time.end_time  = in.positive_number("End time", "the run starts at time 0; give a number > 0");

    if (time.step_size > time.end_time)
      in.fail("Step size",
              "is larger than the end time " + in.text("End time") + ". Reduce the step size or increase `End time`.");
    if (time.end_time / time.step_size > max_steps)
      in.fail("Step size",
              "needs more than a hundred million steps until the end time " + in.text("End time")
                + ". Increase the step size or reduce `End time`.");
    if (time.predictor != "consistent" && time.scheme != "contact-stabilized"
        && time.scheme != "contact-stabilized-projected")
      in.fail("Predictor mass",
              "only the scheme contact-stabilized has a predictor with a mass of its own, but Scheme = " + time.scheme
                + ". Remove this key or set `Scheme = contact-stabilized`.");
    if (time.impulses != "common" && time.scheme != "laursen-love")
      in.fail("Impulses",
              "only the scheme laursen-love gives impulses, but Scheme = " + time.scheme
                + ". Remove this key or set `Scheme = laursen-love`.");
    return time;
  }
} // namespace signorini
