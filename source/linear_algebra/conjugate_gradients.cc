// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/conjugate_gradients.h>
#include <signorini/linear_algebra/improved_guess.h>
#include <signorini/linear_algebra/lanczos.h>
#include <signorini/linear_algebra/vector_kernels.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /** Smallest eigenvalue of P^-1 K below which the norm of P is no longer that of K. */
    constexpr double far_from_one = 0.1;

    /**
     * By how much the norm of the residual must be smaller than what is accepted: the square of the
     * error in the norm of K is up to 1/lambda times that of the residual in that of P^-1.
     */
    double trust_in(const LanczosMatrix &lanczos)
    {
      const double lambda = lanczos.smallest_eigenvalue();
      return lambda > 0. ? std::min(1., std::sqrt(lambda / far_from_one)) : 1.; // 0 by round-off
    }
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

    Report report;
    preconditioner.vmult(preconditioned, residual);
    double       norm_square = dot(residual, preconditioned);
    const double norm        = std::sqrt(std::max(norm_square, 0.));
    const bool   may_improve = is_guess && norm <= tolerance;
    const double accepted    = std::max(tolerance, reduction * norm);
    const double goal        = may_improve ? improved_guess(norm, tolerance) : accepted;

    LanczosMatrix lanczos;
    const auto    iterate_to = [&](const double smaller_norm) {
      while (norm_square > smaller_norm * smaller_norm && report.iterations < maximum_iterations)
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
    iterate_to(goal);
    if (reduction == 0. && !may_improve && norm_square <= goal * goal)
      iterate_to(goal * trust_in(lanczos));
    // A negative square means that the preconditioner is not positive definite, and this is no
    // norm.
    report.converged = std::abs(norm_square) <= accepted * accepted;
    return report;
  }
} // namespace signorini
