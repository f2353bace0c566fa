// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_condensation_nodal_factor_h
#define signorini_condensation_nodal_factor_h

#include <signorini/condensation/multifrontal_factor.h>
#include <signorini/linear_algebra/elastic_matrices.h>

namespace signorini
{
  /**
   * The Cholesky factor of K = a M + b A in Cartesian components, on one process, but for
   * chosen nodes: what is eliminated leaves them the Schur complement
   *
   *   S = K_cc - K_ci K_ii^-1 K_ic,
   *
   * the stiffness of these nodes with the rest of the bodies behind them (static condensation:
   * Guyan, AIAA J. 3 (1965) 380). Prescribed components are zero.
   */
  template <int dim>
  class NodalFactor
  {
  public:
    /**
     * @param prescribed by entry: 1 for components that are zero
     * @param last       the chosen nodes
     * @throws StepError if what is eliminated of K is not definite
     */
    NodalFactor(const ElasticMatrices<dim>      &matrices,
                const MatrixSum                 &sum,
                const std::vector<char>         &prescribed,
                const std::vector<unsigned int> &last);

    /** S, by the entries of the chosen nodes in their order; prescribed ones by themselves. */
    const Eigen::MatrixXd &schur_complement() const { return factor.schur_complement(); }

    /** f_c - K_ci K_ii^-1 f_i: what a force is for the chosen nodes. It is kept for expand(). */
    Eigen::VectorXd condense(const Vector &force);

    /**
     * The displacement of all nodes under the last force that was condensed.
     * @param last displacement of the chosen nodes
     */
    void expand(const Eigen::VectorXd &last, Vector &displacement);

  private:
    std::vector<unsigned int> entries; ///< by position in the factor
    MultifrontalFactor        factor;
    Eigen::VectorXd           values; ///< while it is solved, by position
  };
} // namespace signorini

#endif
