// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_held_values_h
#define signorini_variational_inequality_held_values_h

#include <signorini/base/contact_status.h>
#include <signorini/variational_inequality/constrained_problem.h>

namespace signorini
{
  /** residual = b - K x. */
  inline void
  compute_residual(const ConstrainedProblem &problem, const Vector &solution, Vector &residual)
  {
    problem.matrix.vmult(residual, solution);
    residual.sadd(-1., 1., problem.right_hand_side);
  }

  /**
   * Move fixed entries, and those that statuses hold, to their values. @param status may be empty:
   * fixed entries only. @return how many moved on this process
   */
  inline unsigned int
  move_to_values(const ConstrainedProblem &problem, const ActiveSet &status, Vector &solution)
  {
    unsigned int n_moved = 0;
    const auto   move    = [&](const unsigned int i, const double value) {
      n_moved += (solution.local_element(i) != value);
      solution.local_element(i) = value;
    };
    for (std::size_t j = 0; j < problem.fixed_entries.size(); ++j)
      move(problem.fixed_entries[j], problem.fixed_values[j]);
    for (std::size_t k = 0; k < status.size(); ++k)
      {
        if (contact_status::is_closed(status[k]))
          move(problem.bounded_entries[k], problem.upper_bounds[k]);
        if (contact_status::sticks(status[k]))
          for (unsigned int j = 0; j < problem.friction[k].entries.size(); ++j)
            move(problem.friction[k].entries[j], -problem.friction[k].past[j]);
      }
    return n_moved;
  }
} // namespace signorini

#endif
