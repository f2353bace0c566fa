// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/variational_inequality/node_stiffness.h>
#include <signorini/variational_inequality/tresca_fixed_point.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace signorini
{
  SolveReport
  TrescaFixedPoint::solve(const ConstrainedProblem &problem, ActiveSet &status, Vector &solution, Vector &residual)
  {
    const std::vector<double> stiffness = node_stiffness(problem);
    std::vector<double>       bounds(status.size());
    const auto                bound = [&](const std::size_t k) {
      const double normal =
        !contact_status::is_closed(status[k]) ? 0. : residual.local_element(problem.bounded_entries[k]);
      return problem.friction[k].law.bound(normal);
    };

    ConstrainedProblem given_bounds = problem;
    given_bounds.tolerance *= 0.1; // so that the bounds can settle to the tolerance

    SolveReport report;
    problem.matrix.vmult(residual, solution);
    residual.sadd(-1., 1., problem.right_hand_side);
    for (std::size_t k = 0; k < status.size(); ++k)
      bounds[k] = bound(k);
    for (unsigned int n = 0; n < maximum_iterations; ++n)
      {
        const SolveReport step = minimisation.solve(given_bounds, bounds, status, solution, residual);
        report.active_set_iterations += step.active_set_iterations;
        report.linear_iterations += step.linear_iterations;
        report.n_active = step.n_active;

        double change = 0.; // of the forces of friction, in the norm of the solver
        for (std::size_t k = 0; k < status.size(); ++k)
          {
            const double next = bound(k);
            if (!problem.friction[k].entries.empty())
              change += std::pow(next - bounds[k], 2) / stiffness[k];
            bounds[k] = next;
          }
        change = dealii::Utilities::MPI::sum(change, solution.get_mpi_communicator());
        if (std::sqrt(change) <= problem.tolerance)
          return report;
      }
    throw RunError(
      "The inequality of this step was not solved to its tolerance: neither Newton's method nor the fixed point of "
      "Tresca's friction converged. The friction is too strong for this step: choose a smaller Time/Step size.");
  }
} // namespace signorini
