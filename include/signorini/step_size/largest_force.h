// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_step_size_largest_force_h
#define signorini_step_size_largest_force_h

#include <signorini/base/archive.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * What changes of a contact force are measured by: the largest one so far, or, as long as the
   * elastic energy @f$E_\text{el}@f$ grows beyond all before, that of a spring which will take up
   * the largest energy @f$E@f$ of the motion so far, @f$|r| (E / E_\text{el})^{1/2}@f$. So contact
   * need not begin with the smallest steps.
   */
  class LargestForce
  {
  public:
    /** If a step is accepted. @param force the larger one of both ends */
    double expected(const State &start, const State &end, double force) const;

    /** @param force of the end */
    void accept(const State &start, const State &end, double force);
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
