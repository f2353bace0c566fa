// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_truncated_newton_multigrid_h
#define signorini_variational_inequality_truncated_newton_multigrid_h

#include <signorini/variational_inequality/mprgp.h>

namespace signorini
{
  /**
   * Truncated nonsmooth Newton multigrid (Graeser and Kornhuber, J. Comput. Math. 27 (2009) 1-44)
   * for bounds. One iteration: a projected step along the gradient, scaled by the diagonal;
   * truncation of the entries that are pressed against their bounds; a linear multigrid step on the
   * others (the preconditioner); its projection onto what is feasible; each step as long as the
   * energy falls. While no bound is in the way the multigrid steps are made conjugate to each other
   * and the projected one is left out: then these are conjugate gradients with a V-cycle.
   *
   * The energy falls in every step, so the method converges from any start, and no set of contact
   * nodes has to be solved for before the next one is tried. Where it stagnates, as with a
   * preconditioner that is not positive definite, Mprgp goes on.
   */
  class TruncatedNewtonMultigrid : public ConstrainedSolver
  {
  public:
    explicit TruncatedNewtonMultigrid(const unsigned int maximum_iterations)
      : maximum_iterations(maximum_iterations)
    {
    }

    SolveReport solve(const ConstrainedProblem &problem,
                      ActiveSet                &active,
                      Vector                   &solution,
                      Vector                   &residual) override;

  private:
    const unsigned int maximum_iterations;
    Mprgp              last_resort;
  };
} // namespace signorini

#endif
