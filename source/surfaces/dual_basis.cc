// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/dual_basis.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/LU>

#include <algorithm>

namespace signorini
{
  Eigen::MatrixXd dual_basis(const Eigen::MatrixXd &mass, const std::vector<bool> &carries)
  {
    AssertDimension(mass.cols(), mass.rows());
    AssertDimension(carries.size(), static_cast<std::size_t>(mass.rows()));
    Assert(std::find(carries.begin(), carries.end(), true) != carries.end(),
           dealii::ExcMessage("At least one node of a face carries a multiplier."));
    const Eigen::Index        n = mass.rows();
    std::vector<Eigen::Index> carriers;
    for (Eigen::Index i = 0; i < n; ++i)
      if (carries[i])
        carriers.push_back(i);
    const Eigen::Index m = carriers.size();

    // The carriers with their share of the others: a basis of the multipliers that contains the
    // constants.
    Eigen::MatrixXd extended = Eigen::MatrixXd::Constant(m, n, 1. / static_cast<double>(m));
    for (Eigen::Index a = 0; a < m; ++a)
      for (Eigen::Index b = 0; b < m; ++b)
        extended(b, carriers[a]) = (a == b) ? 1. : 0.;

    const Eigen::MatrixXd product = extended * mass;
    Eigen::MatrixXd       reduced(m, m);
    for (Eigen::Index a = 0; a < m; ++a)
      reduced.col(a) = product.col(carriers[a]);
    const Eigen::MatrixXd psi = reduced.fullPivLu().solve(extended);

    const Eigen::VectorXd integrals = mass.rowwise().sum();
    Eigen::MatrixXd       result    = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index a = 0; a < m; ++a)
      result.row(carriers[a]) = integrals[carriers[a]] * psi.row(a);
    return result;
  }
} // namespace signorini
