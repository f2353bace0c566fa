// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include "parts.h"

#include <signorini/schemes/scheme_table.h>
#include <signorini/schemes/trapezoidal_rule.h>

namespace
{
  using namespace signorini;

  /**
   * The fully implicit scheme whose steps damp what they do not resolve: displacements that are
   * much faster than a step are halved in each. The steps are those of the library; see its header
   * for the equations.
   */
  class DampedContactImplicit : public TimeScheme
  {
  public:
    TakenStep
    make_step(DynamicalSystem &system, const State &start, const double step_size) override
    {
      const Vector            load     = rule.right_hand_side(system, start, step_size);
      const NormalGap         gap      = system.normal_gap(start.displacement);
      const IncrementSolution solution = rule.solve(system, start, step_size, load, gap);
      return rule.finish_implicit(system, start, step_size, solution);
    }

  private:
    const TrapezoidalRule rule{0.5};
  };
} // namespace


void add_damped_scheme()
{
  // What is true of the scheme that it is made of is true of this one.
  SchemeInfo info = scheme_info("contact-implicit");
  info.name       = "contact-implicit-damped";
  info.summary    = "contact-implicit that halves what is much faster than a step, in each step";
  info.keys       = {};
  info.damps_unresolved = false; // always, not where the scene does not say it
  info.make             = [](const SchemeParameters &) -> std::unique_ptr<TimeScheme> {
    return std::make_unique<DampedContactImplicit>();
  };
  add_scheme(info);
}
