// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_largest_force_h
#define signorini_step_size_largest_force_h

#include <signorini/base/archive.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * What changes of contact forces are measured by: the sum of the magnitudes of nodal forces,
   * which sees both bodies, all pairs and friction, where it was largest so far, or, as long as the
   * elastic energy @f$E_\text{el}@f$ grows beyond all before, that of a spring which will take up
   * the largest energy @f$E@f$ of the motion so far, @f$|r|_1 (E / E_\text{el})^{1/2}@f$. So
   * contact need not begin with the smallest steps.
   */
  class LargestForce
  {
  public:
    /** If a step is accepted. */
    double expected(const State &start, const State &end) const;

    void accept(const State &start, const State &end);
    void take_back() { so_far = before; }
    void archive(Archive &archive) { archive(so_far); }

  private:
    struct Largest
    {
      double force = 0., energy = 0., elastic_energy = 0.;
    };
    Largest so_far, before; ///< the step that was accepted last
  };
} // namespace signorini

#endif
