// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/sections.h>
#include <signorini/schemes/scheme_table.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  void declare_step_sizes(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const StepSizeParameters defaults;
    prm.declare_entry("Step size control",
                      name_of(defaults.control),
                      choices_of<StepSizeControl>(),
                      "How long steps are. fixed: all as long as Step size. doubling: so that the "
                      "error of a step, estimated by taking it once more in two halves, stays "
                      "below Step tolerance; the halves are kept. embedded: the same with the "
                      "difference from what the last step predicted, which costs nothing but is "
                      "coarser. force: that of embedded in contact, and by the change of contact "
                      "forces; flight takes the longest steps, whatever vibrates. goal: so that "
                      "steps add about Adaptivity/Target error to the error of the contact force; "
                      "flight as with force. Step size is then the first one, and with force and "
                      "goal the one with which contact begins.");
    prm.declare_entry(
      "Step tolerance",
      "1e-2",
      Double(),
      "Accepted error of a step of variable size (no unit): in the energy norm, relative to the "
      "square root of the largest kinetic and elastic energy of the motion so far; with force also "
      "that part of the largest contact force by which a step of length Step size may change it "
      "(twice the length: a quarter of that). With goal it is Adaptivity/Target error.");
    prm.declare_entry(
      "Minimum step size",
      "0",
      Double(),
      "Steps of variable size are not shorter, whatever their error (but for the "
      "halves of doubling). 0: half the time that a wave takes through the "
      "smallest cell (with doubling all of it, with goal twice that), or Step size if "
      "that is shorter; with force and goal not below an eighth of Step size.");
    prm.declare_entry(
      "Maximum step size",
      "0",
      Double(),
      "Steps of variable size are not longer. 0: a tenth of End time. Make it "
      "short enough that no change of loads and prescribed displacements can be stepped over.");
  }


  StepSizeParameters parse_step_sizes(const SectionReader &in, const TimeParameters &time)
  {
    const StepSizeParameters defaults;
    StepSizeParameters       sizes;
    sizes.control           = in.choice<StepSizeControl>("Step size control");
    sizes.tolerance         = in.number("Step tolerance");
    sizes.minimum           = in.number("Minimum step size");
    sizes.maximum           = in.number("Maximum step size");
    const auto check_unused = [&](const std::string &key, const double value, const double unused) {
      if (value != unused)
        in.fail(key,
                "is for steps of variable size, but Step size control = fixed. Remove this key or "
                "set `Step size control = doubling`.");
    };
    if (sizes.control == StepSizeControl::goal && sizes.tolerance != defaults.tolerance)
      in.fail("Step tolerance",
              "does not fit `Step size control = goal`, whose tolerance is `Adaptivity/Target "
              "error`. Remove this key.");
    if (!sizes.is_variable())
      {
        check_unused("Step tolerance", sizes.tolerance, defaults.tolerance);
        check_unused("Minimum step size", sizes.minimum, defaults.minimum);
        check_unused("Maximum step size", sizes.maximum, defaults.maximum);
        return sizes;
      }
    if (!scheme_info(time.scheme).inertia)
      in.fail("Step size control",
              "does not fit Scheme = " + time.scheme
                + ": it follows the motion, and load steps have none. Remove this key, and choose "
                  "`Step size` by how far loads may grow in a step.");
    if (!scheme_info(time.scheme).variable_step())
      in.fail("Step size control",
              "does not fit Scheme = " + time.scheme
                + ", which controls its error itself within each step. Remove this key, or take "
                  "another scheme.");
    if (!(sizes.tolerance >= 1e-8 && sizes.tolerance <= 1.))
      in.fail("Step tolerance",
              "must lie between 1e-8 and 1: it is relative to the norm of the motion.");
    for (const auto &[key, value] :
         {std::pair("Minimum step size", sizes.minimum), {"Maximum step size", sizes.maximum}})
      if (value < 0.)
        in.fail(key,
                "must not be negative: the run goes forward in time. Give a positive number, or 0 "
                "for the default.");
    if (sizes.minimum > time.step_size)
      in.fail("Minimum step size",
              "is larger than the first `Step size` = " + in.text("Step size")
                + ". Reduce it, or increase `Step size`.");
    if (sizes.maximum > 0. && sizes.maximum < time.step_size)
      in.fail("Maximum step size",
              "is smaller than the first `Step size` = " + in.text("Step size")
                + ". Increase it, or reduce `Step size`.");
    return sizes;
  }


  void set_goal_of_steps(const SectionReader &in,
                         const bool           any_pairs,
                         const double         target_error,
                         StepSizeParameters  &sizes)
  {
    if (sizes.control == StepSizeControl::force && !any_pairs)
      in.fail("Step size control",
              "follows the contact force, and `Contact/Pairs` names nothing that touches: all of "
              "the motion would be taken in the longest steps. Take `doubling` or `embedded`.");
    if (sizes.control != StepSizeControl::goal)
      return;
    if (target_error == 0.)
      in.fail("Step size control",
              "needs `Adaptivity/Target error`, the part of the contact force that may be "
              "wrong. Give for example 0.01 there, with `Indicator = residual` and `Goal = contact "
              "force` or on a mesh that stays (`Indicator = none`), or take another control.");
    sizes.tolerance = target_error;
  }
} // namespace signorini
