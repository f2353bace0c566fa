// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mass_quadratic_moments_h
#define signorini_mass_quadratic_moments_h

#include <deal.II/base/point.h>

#include <Eigen/Dense>

namespace signorini
{
  /**
   * The symmetric products of linear functions at two points, relative to an origin and in units of
   * a length; at one point they are a basis of the quadratic functions. Sums of them over the
   * entries of a mass matrix are total mass, first moments and inertia.
   */
  template <int dim>
  struct QuadraticMoments
  {
    static constexpr unsigned int n = (dim + 1) * (dim + 2) / 2;
    using Values                    = Eigen::Matrix<double, n, 1>;

    dealii::Point<dim> origin;
    double             unit;

    Values at(const dealii::Point<dim> &x, const dealii::Point<dim> &y) const
    {
      std::array<double, dim + 1> a, b;
      a[dim] = b[dim] = 1.;
      for (unsigned int c = 0; c < dim; ++c)
        {
          a[c] = (x[c] - origin[c]) / unit;
          b[c] = (y[c] - origin[c]) / unit;
        }
      Values       values;
      unsigned int k = 0;
      for (unsigned int i = 0; i <= dim; ++i)
        for (unsigned int j = i; j <= dim; ++j)
          values(k++) = 0.5 * (a[i] * b[j] + a[j] * b[i]);
      return values;
    }
  };
} // namespace signorini

#endif
