// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_dual_basis_h
#define signorini_surfaces_dual_basis_h

#include <Eigen/LU>

#include <vector>

namespace signorini
{
  /**
   * Coefficients C of the dual basis psi_i = sum_k C_ik N_k on the covered part of one slave face
   * (Wohlmuth 2000):
   *
   * @f[
   *   \int \psi_i N_j = \delta_{ij} \int N_j
   *   \quad \text{for all nodes } i, j \text{ that carry a multiplier}, \qquad
   *   \sum_i \psi_i = 1.
   * @f]
   *
   * With M over the covered part only, this is the consistent modification for partly covered faces
   * (Cichosz and Bischoff 2011). The shape functions of nodes that carry no multiplier are shared
   * out evenly among the others; their rows are zero, and int psi_i N_k need not vanish for them.
   *
   * @param mass    int N N' over the covered part of the face
   * @param carries whether a node carries a multiplier; at least one has to
   */
  Eigen::MatrixXd dual_basis(const Eigen::MatrixXd &mass, const std::vector<bool> &carries);

  /** The same where all nodes carry a multiplier: psi = D M^-1. */
  template <int n>
  Eigen::Matrix<double, n, n> dual_basis(const Eigen::Matrix<double, n, n> &mass)
  {
    return mass.rowwise().sum().asDiagonal()
           * Eigen::Matrix<double, n, n>(mass.fullPivLu().inverse());
  }
} // namespace signorini

#endif
