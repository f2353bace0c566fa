// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_linear_report_h
#define signorini_linear_algebra_linear_report_h

namespace signorini
{
  /** How a linear solver ended. */
  struct LinearReport
  {
    unsigned int iterations       = 0;
    double       saved_iterations = 0.; ///< see RoughSolver::Report
    bool         converged        = false;
  };
} // namespace signorini

#endif
