// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_diagnostics_oscillation_h
#define signorini_diagnostics_oscillation_h

namespace signorini
{
  /**
   * How far a quantity that should rise and fall once oscillates: its total variation over twice
   * its maximum. 1 for a single hump, the number of humps for equal ones.
   */
  class TotalVariation
  {
  public:
    void   add(double value);
    double measure() const { return maximum > 0. ? variation / (2. * maximum) : 0.; }
    double largest() const { return maximum; }

  private:
    double last = 0., variation = 0., maximum = 0.;
  };

  /**
   * Amplitude of the alternating part of a sequence: the mean of |x_{n+1} - 2 x_n + x_{n-1}| / 4
   * over the values that are counted. A pure zigzag +a, -a gives a, a straight line 0.
   */
  class Zigzag
  {
  public:
    /** @param counts whether the value belongs to the stretch that is judged (contact, say) */
    void   add(double value, bool counts);
    double amplitude() const { return n_counted > 0 ? sum / n_counted : 0.; }

  private:
    double       last = 0., before = 0., sum = 0.;
    unsigned int n_values = 0, n_counted = 0;
  };
} // namespace signorini

#endif
