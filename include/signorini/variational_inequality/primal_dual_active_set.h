// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_primal_dual_active_set_h
#define signorini_variational_inequality_primal_dual_active_set_h

#include <signorini/linear_algebra/conjugate_gradients.h>
#include <signorini/variational_inequality/truncated_newton_multigrid.h>

namespace signorini
{
  /**
   * Primal-dual active set method (Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2003) 865-888),
   * a semismooth Newton method: hold the active entries at their bounds, solve for the free ones,
   * release entries with a negative multiplier, hold those beyond their bound, until nothing
   * changes.
   *
   * The matrix is never modified: held entries are masked in the preconditioner, which masks the
   * search directions. While the set still changes, the linear systems are solved only roughly, and
   * one iteration continues where the last one stopped. The method is known to cycle in rare cases;
   * a set that comes back is detected, first answered by accurate linear solves, and then by
   * TruncatedNewtonMultigrid, in which the energy falls.
   */
  class PrimalDualActiveSet : public ConstrainedSolver
  {
  public:
    explicit PrimalDualActiveSet(const ActiveSetLimits &limits)
      : limits(limits)
      , fallback(limits.maximum_linear_iterations)
    {
    }

    SolveReport solve(const ConstrainedProblem &problem,
                      ActiveSet                &active,
                      Vector                   &solution,
                      Vector                   &residual) override;

  private:
    /** Of the error in a linear solve, while the set still changes. */
    static constexpr double rough_reduction = 1e-2;

    const ActiveSetLimits    limits;
    ConjugateGradients       conjugate_gradients;
    TruncatedNewtonMultigrid fallback;
    Vector                   correction, product;
    Mask                     mask;

    /** Put the fixed and the active entries to their values and compute the residual. */
    void
    start(const ConstrainedProblem &problem, ActiveSet &active, Vector &solution, Vector &residual);
    /** The semismooth Newton update of the set. @return number of changes on all processes */
    unsigned int update(const ConstrainedProblem &problem,
                        ActiveSet                &active,
                        const Vector             &solution,
                        const Vector             &residual) const;
    /** Move fixed and active entries to their values and update the residual. */
    void hold(const ConstrainedProblem &problem,
              const ActiveSet          &active,
              Vector                   &solution,
              Vector                   &residual);
    void set_mask(const ConstrainedProblem &problem, const ActiveSet &active);
  };
} // namespace signorini

#endif
