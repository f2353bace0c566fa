// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/lanczos.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace signorini
{
  void LanczosMatrix::add(const double alpha, const double beta)
  {
    alphas.push_back(alpha);
    betas.push_back(beta);
  }


  double LanczosMatrix::smallest_eigenvalue() const
  {
    return eigenvalues().front();
  }


  double LanczosMatrix::largest_eigenvalue() const
  {
    return eigenvalues().back();
  }


  std::vector<double> LanczosMatrix::eigenvalues() const
  {
    const int n = static_cast<int>(alphas.size());
    if (n == 0)
      return {1.};
    Eigen::VectorXd diagonal(n), beside(n - 1);
    for (int j = 0; j < n; ++j)
      {
        diagonal[j] = 1. / alphas[j] + (j > 0 ? betas[j - 1] / alphas[j - 1] : 0.);
        if (j + 1 < n)
          beside[j] = std::sqrt(betas[j]) / alphas[j];
      }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
    return std::vector<double>(solver.eigenvalues().data(), solver.eigenvalues().data() + n);
  }
} // namespace signorini
