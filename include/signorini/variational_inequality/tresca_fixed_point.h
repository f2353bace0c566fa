// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_tresca_fixed_point_h
#define signorini_variational_inequality_tresca_fixed_point_h

#include <signorini/variational_inequality/constrained_solver.h>
#include <signorini/variational_inequality/tresca_minimisation.h>

namespace signorini
{
  /**
   * Coulomb friction as a sequence of problems with given bounds: the bounds follow from the normal
   * forces of the last problem, until they stand. Each problem is convex and solved by a method
   * that cannot fail; the sequence converges linearly if the friction is not too strong, which
   * small steps guarantee. Where it overshoots, as with strong friction at single nodes, the bounds
   * go a part of the way only. Slower than FrictionalNewton; its solution is the same. A problem is
   * solved as far as its bounds are worth it.
   */
  class TrescaFixedPoint : public ConstrainedSolver
  {
  public:
    explicit TrescaFixedPoint(const unsigned int maximum_iterations = 500)
      : maximum_iterations(maximum_iterations)
    {
    }

    SolveReport solve(const ConstrainedProblem &problem,
                      ActiveSet                &status,
                      Vector                   &solution,
                      Vector                   &residual) override;

    /** A few of the problems: close to the solution, where Newton's method may go on. */
    SolveReport approach(const ConstrainedProblem &problem,
                         ActiveSet                &status,
                         Vector                   &solution,
                         Vector                   &residual);

  private:
    const unsigned int maximum_iterations;
    TrescaMinimisation minimisation;

    /** @param most problems @return whether the bounds stand */
    bool settle(const ConstrainedProblem &problem,
                unsigned int              most,
                ActiveSet                &status,
                Vector                   &solution,
                Vector                   &residual,
                SolveReport              &report);
  };
} // namespace signorini

#endif
