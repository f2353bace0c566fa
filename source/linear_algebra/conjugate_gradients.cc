// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/conjugate_gradients.h>
#include <signorini/linear_algebra/lanczos.h>
#include <signorini/linear_algebra/rough_solver.h>
#include <signorini/linear_algebra/solver_goal.h>
#include <signorini/linear_algebra/vector_kernels.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini
{
  namespace
  {
    /** Of a residual, by which one solve in single precision can reduce it. */
    constexpr double most_digits = 1e-5;
    /** Sought beyond the goal, so that rounding does not miss it. */
    constexpr double surplus = 0.8;
    /**
     * P of symmetric sweeps is larger than K, by L D^-1 L', so that the norm with P^-1 is smaller
     * than the error: by less than this where eigenvalues of P^-1 K are above 1/4, as nearly all
     * are while the mass rules. Without it `bar_2d` drifts by 2.6e-10 of its energy, with it by
     * 2e-11 as with any other preconditioner.
     */
    constexpr double underestimate = 2.;
  } // namespace


  ConjugateGradients::Report ConjugateGradients::solve(const LinearOperator       &matrix,
                                                       const MaskedPreconditioner &preconditioner,
                                                       Vector                     &solution,
                                                       Vector                     &residual,
                                                       const double                tolerance,
                                                       const double                reduction,
                                                       const unsigned int maximum_iterations,
                                                       const bool         is_guess)
  {
    AssertDimension(solution.locally_owned_size(), residual.locally_owned_size());
    Assert(tolerance >= 0. && reduction >= 0. && reduction < 1.,
           dealii::ExcMessage("An accepted error is not negative, and a reduction less than one."));
    if (preconditioned.get_partitioner() != solution.get_partitioner()
        || preconditioned.size() == 0)
      {
        preconditioned.reinit(solution, true);
        direction.reinit(solution, true);
        product.reinit(solution, true);
      }

    const SolverLimits limits{tolerance, reduction, maximum_iterations, is_guess};
    const RoughSolver *rough_solver = preconditioner.rough_solver();
    return rough_solver ? refine(*rough_solver, matrix, solution, residual, limits)
                        : iterate(matrix, preconditioner, solution, residual, limits);
  }


  ConjugateGradients::Report ConjugateGradients::iterate(const LinearOperator       &matrix,
                                                         const MaskedPreconditioner &preconditioner,
                                                         Vector                     &solution,
                                                         Vector                     &residual,
                                                         const SolverLimits         &limits)
  {
    preconditioner.vmult(preconditioned, residual);
    double           norm_square = dot(residual, preconditioned);
    const SolverGoal goal(std::sqrt(std::max(norm_square, 0.)), limits);

    Report        report;
    LanczosMatrix lanczos;
    const auto    iterate_to = [&](const double smaller_norm) {
      while (norm_square > smaller_norm * smaller_norm
             && report.iterations < limits.maximum_iterations)
        {
          matrix.vmult(product, direction);
          ++report.iterations;
          const double curvature = dot(direction, product);
          if (!(curvature > 0.)) // round-off, or a matrix that is not positive definite: the caller
                                 // judges the result
            return;
          const double step = norm_square / curvature;
          advance(step, direction, solution, product, residual);
          preconditioner.vmult(preconditioned, residual);
          const double new_norm_square = dot(residual, preconditioned);
          const double kept            = new_norm_square / norm_square;
          lanczos.add(step, kept);
          extend_direction(preconditioned, kept, direction);
          norm_square = new_norm_square;
        }
    };
    direction = preconditioned;
    iterate_to(goal.sought);
    if (norm_square <= goal.sought * goal.sought)
      iterate_to(goal.sought * goal.trust(lanczos.smallest_eigenvalue()));
    // A negative square means that the preconditioner is not positive definite, and this is no
    // norm.
    report.converged = std::abs(norm_square) <= goal.accepted * goal.accepted;
    return report;
  }


  ConjugateGradients::Report ConjugateGradients::refine(const RoughSolver    &rough_solver,
                                                        const LinearOperator &matrix,
                                                        Vector               &solution,
                                                        Vector               &residual,
                                                        const SolverLimits   &limits)
  {
    Report           report;
    double           norm = underestimate * rough_solver.start(residual), lambda = 1.;
    const SolverGoal goal(norm, limits);
    double           sought = goal.sought;
    while (norm > sought && report.iterations < limits.maximum_iterations)
      {
        const double cycles = std::ceil(std::log(norm / sought) / std::log(1. / most_digits));
        const double factor = std::pow(sought / norm, 1. / cycles) * (cycles == 1. ? surplus : 1.);
        const auto   cycle =
          rough_solver.solve(direction, factor, limits.maximum_iterations - report.iterations);
        report.iterations += cycle.iterations;
        lambda = std::min(lambda, cycle.smallest_eigenvalue);
        solution += direction;
        matrix.vmult(product, direction);
        residual -= product;
        if (limits.reduction > 0. && cycles == 1.)
          {
            report.converged = true; // what follows checks it
            return report;
          }
        const double before = std::exchange(norm, underestimate * rough_solver.start(residual));
        if (!(norm < 0.5 * before))
          break; // round-off: the caller judges the result
        if (norm <= sought)
          sought = goal.sought * goal.trust(lambda);
      }
    report.converged = norm <= goal.accepted;
    return report;
  }
} // namespace signorini
