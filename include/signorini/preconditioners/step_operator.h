// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_preconditioners_step_operator_h
#define signorini_preconditioners_step_operator_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/linear_algebra/linear_operator.h>

namespace signorini
{
  /**
   * T'(a M + b A)T: mass and stiffness in contact coordinates. T is applied on the fly; it touches
   * only contact nodes.
   */
  template <int dim>
  class StepOperator : public LinearOperator
  {
  public:
    StepOperator(const ElasticMatrices<dim>    &matrices,
                 const ContactCoordinates<dim> &coordinates,
                 const MatrixSum               &sum);

    void vmult(Vector &destination, const Vector &source) const override;
    void diagonal(Vector &destination) const override;

  private:
    const ElasticMatrices<dim>    &matrices;
    const ContactCoordinates<dim> &coordinates;
    const MatrixSum                sum;
    mutable Vector                 cartesian;
    mutable Vector
      known_diagonal; ///< once it was asked for: frictional solvers need it in every step

    void compute_diagonal(Vector &destination) const;
  };
} // namespace signorini

#endif
