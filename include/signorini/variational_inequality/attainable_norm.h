// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_attainable_norm_h
#define signorini_variational_inequality_attainable_norm_h

#include <signorini/variational_inequality/constrained_problem.h>

namespace signorini
{
  /**
   * No method makes a residual much smaller than the round-off of its terms. Entry by entry that is
   * @f$\delta_i = \epsilon (|b_i| + K_{ii} |x_i|)@f$, and all of it
   * @f[
   *   \Bigl(\sum_i \frac{\delta_i^2}{K_{ii}}\Bigr)^{1/2},
   * @f]
   * an estimate in the norm of ConstrainedProblem::tolerance. Measured on a block of 128 x 64 cells
   * that slides at a Courant number above 1000, where iterations stood at 4.0e-14: 3.6e-14.
   * Tolerances below it have to be raised to a multiple. Collective; no product with K.
   */
  double attainable_norm(const ConstrainedProblem &problem, const Vector &solution);
} // namespace signorini

#endif
