// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_slip_scaling_h
#define signorini_linear_algebra_slip_scaling_h

#include <Eigen/Eigenvalues>

namespace signorini
{
  /**
   * (I + sym Q)^(-1/2): scales the coordinates of a node that slips so that the stiffness Q of the
   * slip, in terms of that of the node, is taken into the unit diagonal. Negative curvature is left
   * out.
   */
  template <int n>
  Eigen::Matrix<double, n, n> slip_scaling(const Eigen::Matrix<double, n, n> &stiffness)
  {
    const Eigen::Matrix<double, n, n> symmetric = 0.5 * (stiffness + stiffness.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, n, n>> eigen(symmetric);
    const Eigen::Matrix<double, n, 1> scales = (eigen.eigenvalues().array().max(0.) + 1.).rsqrt();
    return eigen.eigenvectors() * scales.asDiagonal() * eigen.eigenvectors().transpose();
  }
} // namespace signorini

#endif
