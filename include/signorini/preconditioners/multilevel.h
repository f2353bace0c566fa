// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_multilevel_h
#define signorini_preconditioners_multilevel_h

#include <signorini/contact/contact_coordinates.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace signorini
{
  /**
   * Smoothed aggregation multigrid (Trilinos ML). The matrix is not masked inside, only in front of
   * and behind the cycle, which costs iterations under contact.
   */
  template <int dim>
  class Multilevel : public MaskedPreconditioner
  {
  public:
    /** Of a M + b A, for steps that are large compared with the cells. */
    Multilevel(const ElasticMatrices<dim>    &matrices,
               const ContactCoordinates<dim> &coordinates,
               const MatrixSum               &sum);

    /**
     * Of A with the Dirichlet conditions built in. The coarse levels know the rotations of each
     * body besides its translations: without them the bending of slender bodies, which turns their
     * parts, takes hundreds of iterations.
     * @param mass_factors of each body: what is added of its M. Positive where Dirichlet conditions
     *                     leave a body free to move, so that the matrix is definite
     */
    Multilevel(const Discretization<dim>     &discretization,
               const ContactCoordinates<dim> &coordinates,
               const std::vector<double>     &mass_factors);

    void set_mask(const Mask &new_mask) override { mask = new_mask; }
    void vmult(Vector &destination, const Vector &source) const override;

  private:
    const ContactCoordinates<dim>            &coordinates;
    dealii::TrilinosWrappers::SparseMatrix    matrix;
    dealii::TrilinosWrappers::PreconditionAMG multigrid;
    Mask                                      mask;
    mutable Vector                            cartesian;

    /**
     * Put the matrix together.
     * @param sum_of sum of the matrices in the row of an owned node
     * @param held   Cartesian entries, ghosts included, whose rows and columns are those of the
     *               identity; null: none
     */
    template <typename SumOf>
    void assemble(const ElasticMatrices<dim> &matrices, const SumOf &sum_of, const Vector *held);
  };
} // namespace signorini

#endif
