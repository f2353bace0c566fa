// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_condensation_dense_operators_h
#define signorini_condensation_dense_operators_h

#include <signorini/base/user_error.h>
#include <signorini/linear_algebra/linear_operator.h>
#include <signorini/linear_algebra/masked_preconditioner.h>

#include <Eigen/Cholesky>

namespace signorini
{
  /** A full symmetric matrix of a small problem on one process. The matrix must outlive it. */
  class DenseOperator : public LinearOperator
  {
  public:
    explicit DenseOperator(const Eigen::MatrixXd &matrix)
      : matrix(matrix)
    {
    }

    void vmult(Vector &destination, const Vector &source) const override
    {
      Eigen::Map<Eigen::VectorXd>(destination.begin(), matrix.rows()).noalias() =
        matrix * Eigen::Map<const Eigen::VectorXd>(source.begin(), matrix.cols());
    }

    void diagonal(Vector &destination) const override
    {
      Eigen::Map<Eigen::VectorXd>(destination.begin(), matrix.rows()) = matrix.diagonal();
    }

  private:
    const Eigen::MatrixXd &matrix;
  };


  /** Its inverse where a mask leaves entries free, by a factor for each mask. */
  class DenseInverse : public MaskedPreconditioner
  {
  public:
    explicit DenseInverse(const Eigen::MatrixXd &matrix)
      : matrix(matrix)
    {
    }

    /** @throws StepError if the free part of the matrix is not definite */
    void set_mask(const Mask &new_mask) override
    {
      if (is_set && new_mask == mask)
        return;
      is_set = false;
      mask   = new_mask;
      free.clear();
      for (std::size_t i = 0; i < mask.size(); ++i)
        if (!mask[i])
          free.push_back(i);
      factor.compute(matrix(free, free));
      if (factor.info() != Eigen::Success)
        throw StepError("the matrix of a step has no Cholesky factor.");
      is_set = true;
    }

    void vmult(Vector &destination, const Vector &source) const override
    {
      const Eigen::VectorXd solution =
        factor.solve(Eigen::Map<const Eigen::VectorXd>(source.begin(), matrix.rows())(free));
      destination = 0.;
      for (std::size_t k = 0; k < free.size(); ++k)
        destination.local_element(free[k]) = solution[k];
    }

  private:
    const Eigen::MatrixXd      &matrix;
    bool                        is_set = false;
    Mask                        mask;
    std::vector<int>            free;
    Eigen::LLT<Eigen::MatrixXd> factor;
  };
} // namespace signorini

#endif
