// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/variational_inequality/held_values.h>
#include <signorini/variational_inequality/primal_dual_active_set.h>
#include <signorini/variational_inequality/status_record.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  SolveReport PrimalDualActiveSet::solve(const ConstrainedProblem &problem,
                                         ActiveSet                &active,
                                         Vector                   &solution,
                                         Vector                   &residual)
  {
    check_sizes(problem, active, solution, residual);
    SolveReport  report;
    StatusRecord record(solution);
    // What continues has most likely the right set.
    double reduction = problem.continues && !problem.is_rough ? 0. : rough_reduction;

    start(problem, active, solution, residual);
    set_mask(problem, active);
    while (report.active_set_iterations < limits.maximum_iterations)
      {
        ++report.active_set_iterations;
        const auto linear =
          conjugate_gradients.solve(problem.matrix,
                                    problem.preconditioner,
                                    solution,
                                    residual,
                                    problem.tolerance,
                                    reduction,
                                    limits.maximum_linear_iterations,
                                    report.linear_iterations == 0 && !problem.continues);
        report.add_iterations(linear.iterations, linear.saved_iterations);
        if (!linear.converged)
          break;

        if (update(problem, active, solution, residual) == 0)
          {
            if (reduction == 0. || problem.is_rough)
              {
                report.n_active = record.n_closed(active);
                return report;
              }
            reduction = 0.; // the set stands: now solve accurately and look once more
            continue;
          }
        if (!record.is_new(active))
          {
            if (reduction == 0.)
              break; // a cycle, and not for want of accuracy
            reduction = 0.;
            record.forget();
          }
        hold(problem, active, solution, residual);
        set_mask(problem, active);
      }

    report.add(fallback.solve(problem, active, solution, residual));
    ++report.n_fallbacks;
    return report;
  }


  void PrimalDualActiveSet::start(const ConstrainedProblem &problem,
                                  ActiveSet                &active,
                                  Vector                   &solution,
                                  Vector                   &residual)
  {
    for (std::size_t k = 0; k < active.size(); ++k)
      if (problem.upper_bounds[k] == std::numeric_limits<double>::infinity())
        active[k] = 0; // a guess from elsewhere
    if (problem.continues || problem.knows_residual)
      {
        hold(problem, active, solution, residual);
        return;
      }
    for (std::size_t j = 0; j < problem.fixed_entries.size(); ++j)
      solution.local_element(problem.fixed_entries[j]) = problem.fixed_values[j];
    for (std::size_t k = 0; k < active.size(); ++k)
      if (active[k])
        solution.local_element(problem.bounded_entries[k]) = problem.upper_bounds[k];
    compute_residual(problem, solution, residual);
  }


  unsigned int PrimalDualActiveSet::update(const ConstrainedProblem &problem,
                                           ActiveSet                &active,
                                           const Vector             &solution,
                                           const Vector             &residual) const
  {
    unsigned int n_changes = 0;
    for (std::size_t k = 0; k < active.size(); ++k)
      {
        const unsigned int i     = problem.bounded_entries[k];
        const double       bound = problem.upper_bounds[k] + problem.bound_tolerance;
        const bool         now =
          active[k] ? residual.local_element(i) >= 0. : solution.local_element(i) > bound;
        n_changes += (now != static_cast<bool>(active[k]));
        active[k] = now;
      }
    return dealii::Utilities::MPI::sum(n_changes, solution.get_mpi_communicator());
  }


  void PrimalDualActiveSet::hold(const ConstrainedProblem &problem,
                                 const ActiveSet          &active,
                                 Vector                   &solution,
                                 Vector                   &residual)
  {
    correction.reinit(solution);
    unsigned int n_moved = 0;
    const auto   move    = [&](const unsigned int i, const double value) {
      const double distance = value - solution.local_element(i);
      n_moved += (distance != 0.);
      correction.local_element(i) = distance;
      solution.local_element(i)   = value;
    };
    for (std::size_t j = 0; j < problem.fixed_entries.size(); ++j)
      move(problem.fixed_entries[j], problem.fixed_values[j]);
    for (std::size_t k = 0; k < active.size(); ++k)
      if (active[k])
        move(problem.bounded_entries[k], problem.upper_bounds[k]);
    if (dealii::Utilities::MPI::sum(n_moved, solution.get_mpi_communicator()) == 0)
      return; // entries were only released: the solution is as it was
    product.reinit(solution, true);
    problem.matrix.vmult(product, correction);
    residual -= product;
  }


  void PrimalDualActiveSet::set_mask(const ConstrainedProblem &problem, const ActiveSet &active)
  {
    mask.assign(problem.right_hand_side.locally_owned_size(), 0);
    for (const unsigned int j : problem.fixed_entries)
      mask[j] = 1;
    for (std::size_t k = 0; k < active.size(); ++k)
      if (active[k])
        mask[problem.bounded_entries[k]] = 1;
    problem.preconditioner.set_mask(mask);
  }
} // namespace signorini
