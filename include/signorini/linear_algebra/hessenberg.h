// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_hessenberg_h
#define signorini_linear_algebra_hessenberg_h

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace signorini
{
  /**
   * The least squares of GMRES, |norm e_0 - H y| -> min, H a Hessenberg matrix that grows column by
   * column: by rotations of Givens it becomes a triangle.
   */
  class Hessenberg
  {
  public:
    Hessenberg(const double norm, const unsigned int most_columns)
      : triangle(Eigen::MatrixXd::Zero(most_columns + 1, most_columns))
      , rest(Eigen::VectorXd::Zero(most_columns + 1))
    {
      rest[0] = norm;
    }

    unsigned int n_columns() const { return rotations.size(); }

    /** What is left with the columns so far. */
    double norm() const { return std::abs(rest[n_columns()]); }

    /** @param column one entry longer than the last one; the first has two */
    void add(const Eigen::VectorXd &column)
    {
      const unsigned int j        = n_columns();
      triangle.col(j).head(j + 2) = column;
      for (unsigned int i = 0; i < j; ++i)
        triangle.col(j).applyOnTheLeft(i, i + 1, rotations[i].adjoint());
      rotations.emplace_back();
      rotations.back().makeGivens(triangle(j, j), triangle(j + 1, j));
      triangle.col(j).applyOnTheLeft(j, j + 1, rotations.back().adjoint());
      rest.applyOnTheLeft(j, j + 1, rotations.back().adjoint());
    }

    /** y */
    Eigen::VectorXd solution() const
    {
      const unsigned int j = n_columns();
      return triangle.topLeftCorner(j, j).triangularView<Eigen::Upper>().solve(rest.head(j));
    }

  private:
    Eigen::MatrixXd                            triangle;
    Eigen::VectorXd                            rest;
    std::vector<Eigen::JacobiRotation<double>> rotations;
  };
} // namespace signorini

#endif
