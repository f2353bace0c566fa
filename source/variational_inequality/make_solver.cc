// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/variational_inequality/frictional_newton.h>
#include <signorini/variational_inequality/make_solver.h>
#include <signorini/variational_inequality/primal_dual_active_set.h>
#include <signorini/variational_inequality/truncated_newton_multigrid.h>

namespace signorini
{
  std::unique_ptr<ConstrainedSolver> make_solver(const bool             with_friction,
                                                 const InequalityMethod method,
                                                 const ActiveSetLimits &limits)
  {
    if (with_friction)
      return std::make_unique<FrictionalNewton>(limits);
    if (method == InequalityMethod::truncated_newton_multigrid)
      return std::make_unique<TruncatedNewtonMultigrid>(limits.maximum_linear_iterations);
    return std::make_unique<PrimalDualActiveSet>(limits);
  }
} // namespace signorini
