// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_constrained_problem_h
#define signorini_variational_inequality_constrained_problem_h

#include <signorini/linear_algebra/linear_operator.h>
#include <signorini/linear_algebra/masked_preconditioner.h>
#include <signorini/variational_inequality/frictional_contact.h>

#include <vector>

namespace signorini
{
  /**
   * The strictly convex problem of every step,
   *
   * @f[
   *   \text{minimise} \quad \tfrac12 x^T K x - b^T x \quad \text{subject to} \quad
   *   x_i \le g_i \text{ (bounded entries)}, \quad x_j = d_j \text{ (fixed entries)}.
   * @f]
   *
   * Its conditions of optimality with the residual s = b - K x:
   *
   * - in free entries s_i = 0,
   * - in bounded entries s_i >= 0, x_i <= g_i, s_i (g_i - x_i) = 0 (s_i is the multiplier),
   * - in fixed entries s_j is minus the reaction.
   *
   * With friction there is no function to minimise: the force t = s_t of a closed node, with the
   * normal force n = s_i, has |t| <= b(n), and |t| = b(n) along the slip where the slip is not zero
   * (Coulomb's law; a quasi-variational inequality).
   *
   * All indices are local; a process lists the entries that it owns.
   */
  struct ConstrainedProblem
  {
    const LinearOperator            &matrix;
    MaskedPreconditioner            &preconditioner;
    const Vector                    &right_hand_side;
    const std::vector<unsigned int> &bounded_entries;
    const std::vector<double>       &upper_bounds; ///< one per bounded entry; infinity: free
    const std::vector<unsigned int> &fixed_entries;
    const std::vector<double>       &fixed_values;
    /**
     * Accepted error in the norm of K, see ConjugateGradients. Absolute; the caller knows the
     * scale of energy.
     */
    double tolerance;
    /** A bound counts as violated beyond this. Absolute, a length. */
    double bound_tolerance;
    /**
     * Friction in the tangential entries of the bounded nodes, which are neither bounded nor
     * fixed; empty: none.
     */
    const Friction &friction = no_friction;

    /**
     * The solution on entry is the latest iterate of nearly this problem, and the residual on entry
     * is b - K x for it; a solver may do without.
     */
    bool continues = false;
    /** A solution may have a hundredth of the error of the guess, but none in what it holds. */
    bool is_rough = false;
    /**
     * The residual on entry is b - K x for the solution on entry, though it solves another problem
     * (where the problem continues it is in any case); a solver may do without.
     */
    bool knows_residual = false;

    static inline const Friction no_friction = {};
  };
} // namespace signorini

#endif
