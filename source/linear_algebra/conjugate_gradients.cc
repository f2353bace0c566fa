// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/interruption.h>
#include <signorini/linear_algebra/conjugate_gradients.h>
#include <signorini/linear_algebra/lanczos.h>
#include <signorini/linear_algebra/rough_solver.h>
#include <signorini/linear_algebra/vector_kernels.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  LinearReport ConjugateGradients::solve(const LinearOperator       &matrix,
                                         const MaskedPreconditioner &preconditioner,
                                         Vector                     &solution,
                                         Vector                     &residual,
                                         const double                tolerance,
                                         const double                reduction,
                                         const unsigned int          maximum_iterations,
                                         const bool                  is_guess)
  {
    AssertDimension(solution.locally_owned_size(), residual.locally_owned_size());
    Assert(tolerance >= 0. && reduction >= 0. && reduction < 1.,
           dealii::ExcMessage("An accepted error is not negative, and a reduction less than one."));
    const SolverLimits limits{tolerance, reduction, maximum_iterations, is_guess};
    const RoughSolver *rough_solver = preconditioner.rough_solver();
    if (rough_solver != nullptr)
      return refinement.solve(
        *rough_solver, matrix, solution, residual, [&](double) { return limits; });
    return iterate(matrix, preconditioner, solution, residual, limits);
  }


  LinearReport ConjugateGradients::iterate(const LinearOperator       &matrix,
                                           const MaskedPreconditioner &preconditioner,
                                           Vector                     &solution,
                                           Vector                     &residual,
                                           const SolverLimits         &limits)
  {
    if (preconditioned.get_partitioner() != solution.get_partitioner()
        || preconditioned.size() == 0)
      {
        preconditioned.reinit(solution, true);
        direction.reinit(solution, true);
        product.reinit(solution, true);
      }

    preconditioner.vmult(preconditioned, residual);
    double           norm_square = dot(residual, preconditioned);
    const SolverGoal goal(std::sqrt(std::max(norm_square, 0.)), limits);

    LinearReport  report;
    LanczosMatrix lanczos;
    const auto    iterate_to = [&](const double smaller_norm) {
      while (norm_square > smaller_norm * smaller_norm
             && report.iterations < limits.maximum_iterations)
        {
          heed_interruption(solution.get_mpi_communicator());
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
} // namespace signorini
