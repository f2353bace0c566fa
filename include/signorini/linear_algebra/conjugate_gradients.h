// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_conjugate_gradients_h
#define signorini_linear_algebra_conjugate_gradients_h

#include <signorini/linear_algebra/linear_operator.h>
#include <signorini/linear_algebra/masked_preconditioner.h>
#include <signorini/linear_algebra/refinement.h>

namespace signorini
{
  /**
   * Preconditioned conjugate gradients on the free entries of K x = b.
   *
   * The held entries need no treatment here: the preconditioner returns zero there, so the search
   * directions leave them alone. The residual is carried for *all* entries. In the held ones it is,
   * at the end, the force that holds them, and no further product is needed to know it.
   *
   * Where the preconditioner can solve by itself in single precision (RoughSolver), it does, and
   * what it finds is refined by residuals in double precision until the same norm is as small.
   */
  class ConjugateGradients
  {
  public:
    /**
     * @param solution  on entry a guess, on exit the solution; held entries are not changed
     * @param residual  b - K x of all entries, on entry and on exit
     * @param tolerance bound for (residual' P^-1 residual)^(1/2) over the free entries, P the
     *                  preconditioner: an estimate of the error in the norm of K. Where the
     *                  iterations show that P^-1 K has an eigenvalue far below 1, for which it is a
     *                  bad one, they go on accordingly; not if `reduction` ends them
     * @param reduction stop earlier if this norm has fallen by this factor since the start
     *                  (0: never)
     * @param is_guess  the solution on entry continues earlier solutions. What is wrong with it is
     *                  alike from step to step and adds up, unlike what is left by iterations; so
     *                  one that is within the tolerance is still improved, tenfold or to a
     *                  hundredth of the tolerance, whatever `reduction` says. One that is not is
     *                  solved like any other
     */
    LinearReport solve(const LinearOperator       &matrix,
                       const MaskedPreconditioner &preconditioner,
                       Vector                     &solution,
                       Vector                     &residual,
                       double                      tolerance,
                       double                      reduction,
                       unsigned int                maximum_iterations,
                       bool                        is_guess = false);

  private:
    LinearReport iterate(const LinearOperator       &matrix,
                         const MaskedPreconditioner &preconditioner,
                         Vector                     &solution,
                         Vector                     &residual,
                         const SolverLimits         &limits);
    Refinement   refinement;
    Vector       preconditioned, direction, product;
  };
} // namespace signorini

#endif
