// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_step_doubling_h
#define signorini_step_size_step_doubling_h

#include <signorini/step_size/embedded_estimate.h>

namespace signorini
{
  /**
   * The span in one step and in two halves; the two halves are kept, and their distance from the
   * single step in the energy norm is the estimate of the error. Nothing is extrapolated: across
   * changes of contact that has no meaning, and the energy of the half steps is accounted for
   * exactly.
   *
   * Without contact one step is enough if the embedded estimate, which is free, is content with it;
   * undeformed flight never needs more.
   */
  class StepDoubling : public StepEstimate
  {
  public:
    explicit StepDoubling(TimeScheme &scheme)
      : scheme(scheme)
      , single(scheme)
    {
    }

    StepTrial
    attempt(DynamicalSystem &system, const State &start, double span, double tolerance) override;
    void accept(const State &start, const State &end) override { single.accept(start, end); }
    void take_back() override { single.take_back(); }

    void archive(Archive &archive) override { single.archive(archive); }

    StepRules rules() const override
    {
      StepRules rules;
      rules.wave_part = 1.; // the halves count
      return rules;
    }

  private:
    TimeScheme      &scheme;
    EmbeddedEstimate single;
  };
} // namespace signorini

#endif
