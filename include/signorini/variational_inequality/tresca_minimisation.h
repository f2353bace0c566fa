// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_tresca_minimisation_h
#define signorini_variational_inequality_tresca_minimisation_h

#include <signorini/variational_inequality/constrained_solver.h>

namespace signorini
{
  /**
   * Contact with friction whose bounds b_k are given numbers (Tresca): the minimum of a convex
   * function,
   *
   *   J(x) = 1/2 x'K x - b'x + sum_k b_k |past_k + x_{k,t}|   subject to   x_i <= g_i,  x_j = d_j.
   *
   * Two moves alternate, each with the exact minimum along its direction, so that J falls in every
   * iteration and the method converges from any start (the idea of the truncated nonsmooth Newton
   * multigrid method, Graeser and Sander, IMA J. Numer. Anal. 39 (2019) 454-481, without the
   * multigrid): a proximal step with the diagonal of K, which decides what is held; and a Newton
   * step of conjugate gradients in what is free, cut where it leaves the smooth piece.
   */
  class TrescaMinimisation
  {
  public:
    explicit TrescaMinimisation(const unsigned int maximum_iterations = 2000)
      : maximum_iterations(maximum_iterations)
    {
    }

    /**
     * @param problem  its laws of friction are not looked at
     * @param bounds   b_k, one per bounded entry
     * @param solution on entry any guess, on exit the minimum
     * @throws RunError if the tolerance is not reached
     */
    SolveReport solve(const ConstrainedProblem  &problem,
                      const std::vector<double> &bounds,
                      ActiveSet                 &status,
                      Vector                    &solution,
                      Vector                    &residual);

  private:
    const unsigned int maximum_iterations;
  };
} // namespace signorini

#endif
