// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_solve_report_h
#define signorini_base_solve_report_h

namespace signorini
{
  /** When an active set method, with or without friction, leaves the rest to its fallback. */
  struct ActiveSetLimits
  {
    unsigned int maximum_iterations        = 50;
    unsigned int maximum_linear_iterations = 10000; ///< of one linear solve
  };

  /** What it took to solve a problem with inequalities. */
  struct SolveReport
  {
    unsigned int active_set_iterations = 0;
    unsigned int linear_iterations     = 0;
    double       saved_iterations      = 0.; ///< of all nodes, for bodies that nothing happens to
    unsigned int n_active              = 0; ///< contact nodes held at their bound, on all processes
    unsigned int n_fallbacks = 0; ///< how often the guaranteed method had to finish the work

    /** Of a linear solve. */
    void add_iterations(const unsigned int iterations, const double saved)
    {
      linear_iterations += iterations;
      saved_iterations += saved;
    }

    /** Go on with another solve: iterations add up, the active nodes are those of the last one. */
    void add(const SolveReport &next)
    {
      active_set_iterations += next.active_set_iterations;
      linear_iterations += next.linear_iterations;
      saved_iterations += next.saved_iterations;
      n_active = next.n_active;
      n_fallbacks += next.n_fallbacks;
    }
  };
} // namespace signorini

#endif
