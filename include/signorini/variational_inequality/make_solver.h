// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_make_solver_h
#define signorini_variational_inequality_make_solver_h

#include <signorini/base/inequality_method.h>
#include <signorini/variational_inequality/constrained_solver.h>

#include <memory>

namespace signorini
{
  /** The solver of the inequalities of steps; the method is for those without friction. */
  std::unique_ptr<ConstrainedSolver>
  make_solver(bool with_friction, InequalityMethod method, const ActiveSetLimits &limits);
} // namespace signorini

#endif
