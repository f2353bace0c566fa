// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_gmres_h
#define signorini_linear_algebra_gmres_h

#include <signorini/linear_algebra/conjugate_gradients.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace signorini
{
  /**
   * GMRES (Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856-869) for matrices that differ
   * from a symmetric one in a few rows. The preconditioner P is symmetric, and residuals are
   * measured by it as conjugate gradients do, (r' P^-1 r)^(1/2), in the free entries: tolerances
   * mean the same, and for a symmetric matrix the iterates are close to those of conjugate
   * gradients.
   *
   * As there, the preconditioner returns zero in held entries, and the residual is carried for all
   * entries without further products.
   */
  class Gmres
  {
  public:
    using Operator = std::function<void(Vector &destination, const Vector &source)>;

    /**
     * @param correction     on exit the solution of J x = residual, started from zero
     * @param residual       on entry the right-hand side, on exit the residual in all entries
     * @param limits_for     what is accepted, given the norm of the residual at the start
     */
    LinearReport solve(const Operator  &matrix,
                       const Operator  &inverse_of_preconditioner,
                       Vector          &correction,
                       Vector          &residual,
                       const LimitsFor &limits_for);

    /** The norm of the residual at the start of the last solve. */
    double initial_norm() const { return norm_at_start; }

    /**
     * What round-off has left in the residual of the last solve, as a norm: large where the space
     * was nearly exhausted, and directions cancel. One more product would show it.
     */
    double round_off() const { return lost; }

  private:
    static constexpr unsigned int n_basis = 50; ///< then a restart

    double              norm_at_start = 0., lost = 0.;
    std::vector<Vector> basis, preconditioned; ///< v_j and P^-1 v_j, kept for the next solve

    /**
     * One cycle; P^-1 residual is in the first of `preconditioned`. @return iterations; `norm` is
     * the estimated norm of the residual on exit
     */
    unsigned int cycle(const Operator &matrix,
                       const Operator &inverse_of_preconditioner,
                       Vector         &correction,
                       Vector         &residual,
                       double          goal,
                       unsigned int    maximum_iterations,
                       double         &norm);

    /** The end of a cycle: what j directions y_i P^-1 v_i change, with J P^-1 v in the basis. */
    void take(unsigned int           j,
              const Eigen::MatrixXd &hessenberg,
              const Eigen::VectorXd &y,
              Vector                &correction,
              Vector                &residual);
  };
} // namespace signorini

#endif
