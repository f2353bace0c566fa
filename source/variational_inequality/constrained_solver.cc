// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/variational_inequality/constrained_solver.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace signorini
{
  void check_sizes(const ConstrainedProblem &problem,
                   const ActiveSet          &active,
                   const Vector             &solution,
                   const Vector             &residual)
  {
    using namespace dealii;
    const std::size_t n_bounded = problem.bounded_entries.size();
    AssertDimension(problem.upper_bounds.size(), n_bounded);
    AssertDimension(active.size(), n_bounded);
    AssertDimension(problem.fixed_values.size(), problem.fixed_entries.size());
    Assert(problem.friction.empty() || problem.friction.size() == n_bounded,
           ExcDimensionMismatch(problem.friction.size(), n_bounded));
    AssertDimension(solution.size(), problem.right_hand_side.size());
    AssertDimension(residual.size(), problem.right_hand_side.size());
    Assert(problem.tolerance >= 0., ExcMessage("The accepted error must not be negative."));
    Assert(problem.bound_tolerance >= 0., ExcMessage("The tolerance of bounds is a length."));
    for ([[maybe_unused]] const double bound : problem.upper_bounds)
      Assert(!std::isnan(bound), ExcMessage("A bound is not a number."));
    (void)n_bounded, (void)active, (void)solution, (void)residual;
  }
} // namespace signorini
