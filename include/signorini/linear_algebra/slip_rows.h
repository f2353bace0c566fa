// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_slip_rows_h
#define signorini_linear_algebra_slip_rows_h

#include <Eigen/Core>

#include <deal.II/base/tensor.h>

#include <vector>

namespace signorini
{
  /**
   * What a node that slips adds to the rows of K of its tangential entries x_t: Q x_t - q (K x)_n,
   * n its normal entry. All entries are local.
   */
  struct SlipRows
  {
    unsigned int              normal;
    std::vector<unsigned int> entries;                             ///< tangential: one or two
    Eigen::Matrix2d           stiffness = Eigen::Matrix2d::Zero(); ///< Q
    Eigen::Vector2d           coupling  = Eigen::Vector2d::Zero(); ///< q
  };

  /** The same in the components of a node. */
  template <int dim>
  struct NodeSlip
  {
    unsigned int           node; ///< owned
    dealii::Tensor<1, dim> normal;
    dealii::Tensor<2, dim> stiffness;
    dealii::Tensor<1, dim> coupling;
  };
} // namespace signorini

#endif
