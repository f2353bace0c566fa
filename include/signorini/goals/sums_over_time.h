// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_sums_over_time_h
#define signorini_goals_sums_over_time_h

#include <signorini/base/archive.h>

namespace signorini
{
  /**
   * Sums over the judgements of a run, each of which stands for the time since the one before. A
   * repeated step replaces what was summed up for the same time.
   */
  template <typename Sums>
  class SumsOverTime
  {
  public:
    /**
     * A judgement at a time, whose numbers are added to `sums` after that.
     * @param first how long the first judgement of all stands for @return whether the time is new
     */
    bool begin(const double time, const double first)
    {
      const bool is_new = time > latest * (1. + round_off);
      if (is_new)
        {
          earlier  = sums;
          interval = latest > 0. ? time - latest : first;
          latest   = time;
        }
      sums = earlier;
      return is_new;
    }

    double length() const { return interval; } ///< of the time that the latest judgement stands for

    void archive(Archive &archive) { archive(sums, earlier, latest, interval); }

    Sums sums;

  private:
    /** A step that is made again may end at a time with another last digit. */
    static constexpr double round_off = 1e-12;

    Sums   earlier; ///< without the latest judgement
    double latest   = 0.;
    double interval = 0.;
  };
} // namespace signorini

#endif
