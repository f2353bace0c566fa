// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_mprgp_h
#define signorini_variational_inequality_mprgp_h

#include <signorini/variational_inequality/constrained_solver.h>

namespace signorini
{
  /**
   * Modified proportioning with reduced gradient projections (MPRGP; Dostal and Schoeberl, Comput.
   * Optim. Appl. 30 (2005) 23-43), scaled by the diagonal. Slower than the active set method, but
   * its energy falls in every iteration and convergence is proved for every strictly convex problem
   * with bounds, from any start.
   */
  class Mprgp : public ConstrainedSolver
  {
  public:
    explicit Mprgp(const unsigned int maximum_iterations = 100000)
      : maximum_iterations(maximum_iterations)
    {
    }

    SolveReport solve(const ConstrainedProblem &problem,
                      ActiveSet                &active,
                      Vector                   &solution,
                      Vector                   &residual) override;

  private:
    const unsigned int maximum_iterations;
  };
} // namespace signorini

#endif
