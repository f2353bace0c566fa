// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/variational_inequality/attainable_norm.h>
#include <signorini/variational_inequality/held_values.h>
#include <signorini/variational_inequality/node_stiffness.h>
#include <signorini/variational_inequality/tresca_fixed_point.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /** What is accepted at least, in what round-off leaves of a residual: ten times what
     * TrescaMinimisation accepts. */
    constexpr double bounds_beyond_round_off = 100.;

    /** Of what a problem is to be solved to: of the first, in the forces of friction; of the next
     * ones, in the last change of these. */
    constexpr double first_accuracy = 1e-2, accuracy_of_bounds = 0.1;

    constexpr unsigned int problems_to_approach = 2;
  } // namespace


  SolveReport TrescaFixedPoint::solve(const ConstrainedProblem &problem,
                                      ActiveSet                &status,
                                      Vector                   &solution,
                                      Vector                   &residual)
  {
    SolveReport report;
    if (!settle(problem, maximum_iterations, status, solution, residual, report))
      throw StepError(
        "The inequality of this step was not solved to its tolerance: neither Newton's method nor "
        "the fixed point of Tresca's friction converged. The friction is too strong for this step: "
        "choose a smaller Time/Step size.");
    return report;
  }


  SolveReport TrescaFixedPoint::approach(const ConstrainedProblem &problem,
                                         ActiveSet                &status,
                                         Vector                   &solution,
                                         Vector                   &residual)
  {
    SolveReport report;
    settle(problem, problems_to_approach, status, solution, residual, report);
    return report;
  }


  bool TrescaFixedPoint::settle(const ConstrainedProblem &problem,
                                const unsigned int        most,
                                ActiveSet                &status,
                                Vector                   &solution,
                                Vector                   &residual,
                                SolveReport              &report)
  {
    check_sizes(problem, status, solution, residual);
    AssertDimension(problem.friction.size(), status.size());
    const std::vector<double> stiffness = node_stiffness(problem);
    std::vector<double>       bounds(status.size()), changes(status.size(), 0.);
    const auto                bound = [&](const std::size_t k) {
      const double normal = !contact_status::is_closed(status[k])
                                             ? 0.
                                             : residual.local_element(problem.bounded_entries[k]);
      return problem.friction[k].law.bound(normal);
    };

    ConstrainedProblem given_bounds = problem;
    const double least      = 0.1 * problem.tolerance; // so that bounds can settle to the tolerance
    double       relaxation = 1., last_change = 0., size = 0.;
    compute_residual(problem, solution, residual);
    for (std::size_t k = 0; k < status.size(); ++k)
      {
        bounds[k] = problem.friction[k].entries.empty() ? 0. : bound(k);
        size += bounds[k] * bounds[k] / stiffness[k];
      }
    size = std::sqrt(dealii::Utilities::MPI::sum(size, solution.get_mpi_communicator()));
    for (unsigned int n = 0; n < most; ++n)
      {
        given_bounds.tolerance =
          std::max(least, n == 0 ? first_accuracy * size : accuracy_of_bounds * last_change);
        report.add(minimisation.solve(given_bounds, bounds, status, solution, residual));

        // Of the changes of the forces of friction, in the norm of the solver.
        dealii::Tensor<1, 2> products;
        for (std::size_t k = 0; k < status.size(); ++k)
          {
            const double last = changes[k];
            changes[k]        = problem.friction[k].entries.empty() ? 0. : bound(k) - bounds[k];
            products[0] += changes[k] * changes[k] / stiffness[k];
            products[1] += changes[k] * last / stiffness[k];
          }
        products = dealii::Utilities::MPI::sum(products, solution.get_mpi_communicator());
        const double change = std::sqrt(products[0]);
        const double stands =
          std::max(problem.tolerance, bounds_beyond_round_off * attainable_norm(problem, solution));
        if (change <= stands && given_bounds.tolerance <= 0.1 * stands)
          return true;
        if (products[1] < 0. && change > 0.5 * last_change)
          relaxation *= 0.5;
        last_change = change;
        for (std::size_t k = 0; k < status.size(); ++k)
          bounds[k] += relaxation * changes[k];
      }
    return false;
  }
} // namespace signorini
