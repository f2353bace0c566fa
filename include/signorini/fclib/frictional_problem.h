// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_fclib_frictional_problem_h
#define signorini_fclib_frictional_problem_h

#include <Eigen/SparseCore>

namespace signorini
{
  /**
   * The problem of a step as the Frictional Contact Library (FCLIB) states it, with its solution:
   *
   * @f[
   *   M v = H r + f, \quad u = H^T v + w,
   * @f]
   *
   * and in each contact, with the normal component first,
   *
   * - @f$u_N \ge 0@f$, @f$r_N \ge 0@f$, @f$u_N r_N = 0@f$,
   * - @f$|r_T| \le \mu r_N@f$, and @f$r_T = -\mu r_N u_T/|u_T|@f$ where @f$u_T@f$ is not zero.
   *
   * Increments of the step are divided by its size, so that v and u are its mean velocities (u_N
   * that with which the gap at its end would open), M a mass, and r and f impulses.
   */
  struct FrictionalProblem
  {
    using Matrix = Eigen::SparseMatrix<double>;

    unsigned int    dim = 0; ///< components per contact
    Matrix          M;       ///< over the displacements that are not prescribed, Cartesian
    Matrix          H;       ///< columns: the frames of the contacts, relative to the other side
    Eigen::VectorXd f, w;
    Eigen::VectorXd mu;      ///< one per contact
    Eigen::VectorXd v, u, r; ///< the solution of the program

    unsigned int step       = 0;
    double       start_time = 0., step_size = 0.;
    double       force_per_reaction = 0.; ///< nodal contact force of the step over r

    /** Whether a contact bears a force. */
    bool any_contact() const { return r.size() > 0 && r.lpNorm<Eigen::Infinity>() > 0.; }
  };

  /** The same without v: u = W r + q with W = H' M^-1 H, q = H' M^-1 f + w. */
  struct LocalForm
  {
    FrictionalProblem::Matrix W; ///< full, symmetric
    Eigen::VectorXd           q;
  };

  /** Whether the local form is small enough to be made, and to be of use. */
  bool has_local_form(const FrictionalProblem &problem);

  /** By a factor of M. @throws RunError if there is none */
  LocalForm local_form(const FrictionalProblem &problem);
} // namespace signorini

#endif
