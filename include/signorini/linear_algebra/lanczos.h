// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_lanczos_h
#define signorini_linear_algebra_lanczos_h

#include <vector>

namespace signorini
{
  /**
   * What the coefficients of conjugate gradients say about the spectrum of the preconditioned
   * matrix P^-1 K: they are the entries of the tridiagonal matrix of Lanczos' method, whose extreme
   * eigenvalues soon are those of P^-1 K (Saad, Iterative Methods 2003, section 6.7.3).
   */
  class LanczosMatrix
  {
  public:
    /**
     * One iteration. @param alpha the step along its direction @param beta part of the direction
     * that the next one keeps
     */
    void add(double alpha, double beta);

    /** An upper bound of the smallest eigenvalue of P^-1 K; 1 without any iteration. */
    double smallest_eigenvalue() const;

    /** A lower bound of the largest one, which soon is close; 1 without any iteration. */
    double largest_eigenvalue() const;

  private:
    std::vector<double> alphas, betas;

    /** Of the tridiagonal matrix, ascending; 1 if it is empty. */
    std::vector<double> eigenvalues() const;
  };
} // namespace signorini

#endif
