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
   * Smoothed aggregation multigrid (Trilinos ML) of a M + b A, for steps that are large compared
   * with the cells. The matrix is not masked inside, only in front of and behind the cycle, which
   * costs iterations under contact.
   */
  template <int dim>
  class Multilevel : public MaskedPreconditioner
  {
  public:
    Multilevel(const ElasticMatrices<dim>    &matrices,
               const ContactCoordinates<dim> &coordinates,
               const MatrixSum               &sum);

    void set_mask(const Mask &new_mask) override { mask = new_mask; }
    void vmult(Vector &destination, const Vector &source) const override;

  private:
    const ContactCoordinates<dim>            &coordinates;
    dealii::TrilinosWrappers::SparseMatrix    matrix;
    dealii::TrilinosWrappers::PreconditionAMG multigrid;
    Mask                                      mask;
    mutable Vector                            cartesian;
  };
} // namespace signorini

#endif
