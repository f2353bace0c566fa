// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_rough_solver_h
#define signorini_linear_algebra_rough_solver_h

#include <signorini/base/types.h>
#include <signorini/linear_algebra/lanczos.h>

namespace signorini
{
  /**
   * Solves K c = r on the free entries by itself, in single precision: for a few digits, at a
   * fraction of the price of products in double precision. Residuals in double precision outside
   * make it exact (iterative refinement: Wilkinson 1963, Martin, Peters and Wilkinson 1966).
   */
  class RoughSolver
  {
  public:
    virtual ~RoughSolver() = default;

    /**
     * Take the right-hand side of the next solve().
     * @return its norm (r'P^-1 r)^(1/2) over the free entries, P the preconditioner. Collective
     */
    virtual double start(const Vector &residual) const = 0;

    struct Report
    {
      unsigned int iterations = 0;
      /** Of all nodes: iterations that left some out count as their share. */
      double saved_iterations = 0.;
      /** Whether the norm is as small as it was asked for, by what the iterations know. */
      bool reached = false;
      /** Of P^-1 K, from above; 1 without an iteration. */
      double smallest_eigenvalue = 1.;
    };

    /**
     * @param correction         on exit c, zero in the held entries
     * @param reduction          of the norm that start() returned, at which to stop; what single
     *                           precision can do ends at about 1e-5
     * @param maximum_iterations stop there in any case
     */
    virtual Report
    solve(Vector &correction, double reduction, unsigned int maximum_iterations) const = 0;
  };
} // namespace signorini

#endif
