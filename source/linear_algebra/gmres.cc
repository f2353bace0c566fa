// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/interruption.h>
#include <signorini/linear_algebra/gmres.h>
#include <signorini/linear_algebra/hessenberg.h>
#include <signorini/linear_algebra/vector_kernels.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** Of a norm by the recurrence; beyond, round-off of the preconditioner may be all there is. */
    constexpr double trusted_reduction = 1e-3;

    /**
     * A direction of which so little is new is one of round-off: in single precision a
     * preconditioner leaves 1e-7 of the others in it.
     */
    constexpr double nothing_new = 1e-6;

    /** Room for entry j of a basis, like a given vector. */
    Vector &place(std::vector<Vector> &basis, const unsigned int j, const Vector &like)
    {
      if (basis.size() <= j)
        basis.resize(j + 1);
      if (basis[j].size() == 0 || basis[j].get_partitioner() != like.get_partitioner())
        basis[j].reinit(like, true);
      return basis[j];
    }
  } // namespace


  LinearReport Gmres::solve(const Operator  &matrix,
                            const Operator  &inverse_of_preconditioner,
                            Vector          &correction,
                            Vector          &residual,
                            const LimitsFor &limits_for)
  {
    LinearReport report;
    correction.reinit(residual);
    Vector &first = place(preconditioned, 0, residual);
    inverse_of_preconditioner(first, residual);
    const double square       = dot(residual, first);
    double       norm         = std::sqrt(std::max(0., square));
    norm_at_start             = norm;
    lost                      = 0.;
    const SolverLimits limits = limits_for(norm);
    const double       goal   = SolverGoal(norm, limits).accepted;
    Assert(!(goal < 0.), dealii::ExcMessage("The accepted norm of a residual is not negative."));
    if (square < -goal * goal) // the preconditioner is not positive definite, and this is no norm
      return report;
    while (!(report.converged = norm <= goal) && report.iterations < limits.maximum_iterations)
      {
        const double       before = norm;
        const unsigned int done   = cycle(matrix,
                                        inverse_of_preconditioner,
                                        correction,
                                        residual,
                                        goal,
                                        limits.maximum_iterations - report.iterations,
                                        norm);
        report.iterations += done;
        // The recurrence knows the norm as far as the preconditioner is linear and symmetric.
        if (norm > goal || norm < trusted_reduction * before)
          {
            inverse_of_preconditioner(preconditioned[0], residual);
            norm = std::sqrt(std::max(0., dot(residual, preconditioned[0])));
          }
        if (done == 0
            || (norm > goal && norm > 0.99 * before)) // stagnates: the caller judges the result
          break;
      }
    return report;
  }


  unsigned int Gmres::cycle(const Operator    &matrix,
                            const Operator    &inverse_of_preconditioner,
                            Vector            &correction,
                            Vector            &residual,
                            const double       goal,
                            const unsigned int maximum_iterations,
                            double            &norm)
  {
    const unsigned int m        = std::min(n_basis, maximum_iterations);
    Eigen::MatrixXd    original = Eigen::MatrixXd::Zero(m + 1, m); // Hessenberg
    Hessenberg         hessenberg(norm, m);

    place(basis, 0, residual).equ(1. / norm, residual);
    preconditioned[0] /= norm;
    unsigned int j = 0;
    for (; j < m && norm > goal; ++j)
      {
        heed_interruption(residual.get_mpi_communicator());
        Vector &next = place(basis, j + 1, residual);
        matrix(next, preconditioned[j]);
        for (unsigned int i = 0; i <= j; ++i)
          {
            original(i, j) = dot(next, preconditioned[i]);
            next.add(-original(i, j), basis[i]);
          }
        Vector &z = place(preconditioned, j + 1, residual);
        inverse_of_preconditioner(z, next);
        original(j + 1, j) = std::sqrt(std::max(0., dot(next, z)));
        hessenberg.add(original.col(j).head(j + 2));
        norm = hessenberg.norm();
        if (original(j + 1, j) <= nothing_new * original.col(j).norm()) // the space is exhausted
          {
            original(j + 1, j) =
              1.; // what is left is round-off, or acts on held entries, and is not normalised
            ++j;
            break;
          }
        next /= original(j + 1, j);
        z /= original(j + 1, j);
      }
    if (j == 0)
      return 0;

    take(j, original.topLeftCorner(j + 1, j), hessenberg.solution(), correction, residual);
    return j;
  }


  void Gmres::take(const unsigned int     j,
                   const Eigen::MatrixXd &hessenberg,
                   const Eigen::VectorXd &y,
                   Vector                &correction,
                   Vector                &residual)
  {
    const Eigen::VectorXd change = hessenberg * y; // J x in the basis
    const Eigen::VectorXd passed = hessenberg.cwiseAbs() * y.cwiseAbs();
    lost = std::max(lost, std::numeric_limits<double>::epsilon() * passed.norm());
    for (unsigned int i = 0; i < j; ++i)
      correction.add(y[i], preconditioned[i]);
    for (unsigned int i = 0; i <= j; ++i)
      residual.add(-change[i], basis[i]);
  }
} // namespace signorini
