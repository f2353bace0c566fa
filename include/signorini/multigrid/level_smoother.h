// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_multigrid_level_smoother_h
#define signorini_multigrid_level_smoother_h

#include <signorini/multigrid/free_space.h>
#include <signorini/multigrid/held_correction.h>

namespace signorini
{
  /**
   * Chebyshev iteration with the diagonal blocks of the nodes for a M + b A on one level: in the
   * range of G on the finest level, with what held entries change on the others. The residual is
   * carried along, so that a sweep of degree n from zero that leaves its residual costs n products,
   * and one that does not n - 1.
   */
  template <int dim, typename Number>
  class LevelSmoother
  {
  public:
    /**
     * Estimates the largest eigenvalue. Collective. The matrix must outlive the object.
     * @param free of the finest level; else null
     */
    LevelSmoother(const LevelMatrix<dim, Number> &matrix, const FreeSpace<dim, Number> *free);

    /** On the finest level: the free space has changed. Collective. */
    void update_free_space();
    /** On another one: the matrix changes by this. Collective. */
    void set_correction(const HeldCorrection<dim, Number> &correction, unsigned int level);

    /** x = smoother r, from zero, and r -= K x. */
    void start(LevelVector<Number> &residual, LevelVector<Number> &solution) const;
    /** r -= K c. */
    void subtract_product(const LevelVector<Number> &displacement,
                          LevelVector<Number>       &residual) const;
    /** x += smoother r; r is used up. */
    void finish(LevelVector<Number> &residual, LevelVector<Number> &solution) const;

  private:
    using Block   = typename LevelMatrix<dim, Number>::Block;
    using Inverse = std::array<Number, dim * dim>; ///< column by column

    const LevelMatrix<dim, Number>    &matrix;
    const FreeSpace<dim, Number>      *free;
    const HeldCorrection<dim, Number> *correction = nullptr;
    unsigned int                       level      = 0;
    std::vector<Inverse>               inverse; ///< with a spare one at the end, see Lanes
    std::vector<unsigned int>   changed; ///< nodes whose inverse is not that of their own block
    double                      largest = 1.; ///< eigenvalue
    mutable LevelVector<Number> direction;

    void set_inverse(unsigned int node, const Block &block);
    void reset_changed();
    /** Of D^-1 K, as Lanczos' method finds it from a force on some nodes. Collective. */
    double largest_eigenvalue(const std::vector<unsigned int> &start, unsigned int n_steps) const;
    void   weaken_changed();
    /** direction = factor D^-1 r + kept direction, in the free space. */
    void step(double factor, double kept, LevelVector<Number> &residual) const;
    void iterate(LevelVector<Number> &residual,
                 LevelVector<Number> &solution,
                 bool                 leave_residual) const;
  };
} // namespace signorini

#endif
