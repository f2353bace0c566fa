// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mass_mass_solver_h
#define signorini_mass_mass_solver_h

#include <signorini/linear_algebra/elastic_matrices.h>

namespace signorini
{
  /**
   * Solution with a mass that leaves some nodes without any, by conjugate gradients with the
   * diagonal as preconditioner: a handful of iterations, whatever the mesh. Needed once per run, so
   * that nothing faster is called for.
   */
  template <int dim>
  class MassSolver
  {
  public:
    /** @param held local entries that are zero besides those of massless nodes */
    MassSolver(const ElasticMatrices<dim> &matrices, const std::vector<unsigned int> &held);

    /** M~^-1 force on the free entries, zero on the others. Collective. */
    Vector solve(const Vector &force) const;

    /**
     * Estimate of the smallest eigenvalue of D^-1 M~ on the free entries, D the diagonal of M~
     * (between 1/8 and 1 for the consistent mass of bricks): positive if and only if M~ is positive
     * definite there. Minus infinity if a diagonal entry is not positive. Collective.
     */
    double smallest_ratio() const;

  private:
    const ElasticMatrices<dim> &matrices;
    Vector                      inverse_diagonal; ///< zero on entries that are held
  };
} // namespace signorini

#endif
