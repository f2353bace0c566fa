// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_dual_number_h
#define signorini_base_dual_number_h

#include <deal.II/base/tensor.h>

#include <cmath>

namespace signorini
{
  /**
   * The value of a function at a point and its gradient there, which follows the value through
   * every operation: automatic differentiation in forward mode, exact up to round-off.
   *
   * Where a function has a kink the gradient is the mean of its sides (0 for the modulus at 0).
   * Where it has no gradient, as the root at 0, the result is not finite. A part of the argument
   * that does not change changes nothing, though: sqrt(x^2 + y^2) has gradient 0 at its tip, the
   * mean of all sides.
   */
  template <int dim>
  struct DualNumber
  {
    double                 value = 0.;
    dealii::Tensor<1, dim> gradient;
  };


  /** A function of one argument by the chain rule. @param value of the function, @param slope of it
   */
  template <int dim>
  DualNumber<dim>
  chain_rule(const DualNumber<dim> &argument, const double value, const double slope)
  {
    DualNumber<dim> result{value, {}};
    for (unsigned int c = 0; c < dim; ++c)
      if (argument.gradient[c] != 0.)
        result.gradient[c] = slope * argument.gradient[c];
    return result;
  }


  template <int dim>
  DualNumber<dim> operator+(const DualNumber<dim> &a, const DualNumber<dim> &b)
  {
    return {a.value + b.value, a.gradient + b.gradient};
  }


  template <int dim>
  DualNumber<dim> operator-(const DualNumber<dim> &a, const DualNumber<dim> &b)
  {
    return {a.value - b.value, a.gradient - b.gradient};
  }


  template <int dim>
  DualNumber<dim> operator-(const DualNumber<dim> &a)
  {
    return {-a.value, -a.gradient};
  }


  template <int dim>
  DualNumber<dim> operator*(const DualNumber<dim> &a, const DualNumber<dim> &b)
  {
    return {a.value * b.value, a.value * b.gradient + b.value * a.gradient};
  }


  template <int dim>
  DualNumber<dim> operator/(const DualNumber<dim> &a, const DualNumber<dim> &b)
  {
    const double quotient = a.value / b.value;
    return {quotient, (a.gradient - quotient * b.gradient) / b.value};
  }


  /** a to the power of b. */
  template <int dim>
  DualNumber<dim> power(const DualNumber<dim> &a, const DualNumber<dim> &b)
  {
    const double value    = std::pow(a.value, b.value);
    const double by_base  = b.value == 0. ? 0. : b.value * std::pow(a.value, b.value - 1.);
    const double by_power = value == 0. ? 0. : value * std::log(a.value);
    return {value,
            chain_rule(a, value, by_base).gradient + chain_rule(b, value, by_power).gradient};
  }


  /** The larger one of two, with the mean of their gradients if they are equal. */
  template <int dim>
  DualNumber<dim> larger(const DualNumber<dim> &a, const DualNumber<dim> &b)
  {
    if (a.value == b.value)
      return {a.value, 0.5 * (a.gradient + b.gradient)};
    return a.value > b.value ? a : b;
  }
} // namespace signorini

#endif
