// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_integral_of_rate_h
#define signorini_obstacles_integral_of_rate_h

#include <functional>
#include <vector>

namespace signorini
{
  /**
   * The integral of a rate from time 0 on. It is summed over panels of time, adaptively in each, so
   * that a pulse that comes and goes is found, or missed, whatever the end: integrals from 0 to
   * different ends, each adaptive on its own, would jump back and forth.
   */
  class IntegralOfRate
  {
  public:
    /**
     * @param rate   of time
     * @param varies whether it depends on time
     * @param panel  time; pulses that are much shorter may be missed
     */
    IntegralOfRate(std::function<double(double)> rate, bool varies, double panel);

    /** @param time not before 0 */
    double operator()(double time);

    /** From each of equal parts to the next one, about: by Simpson's rule. */
    std::vector<double> over_parts(double start, double end, unsigned int n_parts) const;

  private:
    const std::function<double(double)> rate;
    const bool                          varies;
    const double                        panel;
    std::vector<double>                 up_to; ///< the beginning of each panel

    double between(double start, double end) const;
  };
} // namespace signorini

#endif
