// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/differentiable_functions.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

namespace signorini
{
  using dealii::numbers::PI;

  double rounded_half_away(const double value)
  {
    return std::trunc(value + (value >= 0. ? 0.5 : -0.5));
  }


  namespace
  {
    template <int dim>
    using Arguments = std::vector<DualNumber<dim>>;

    double sign(const double x)
    {
      return x > 0. ? 1. : (x < 0. ? -1. : 0.);
    }

    double zero(const double)
    {
      return 0.;
    }

    double square(const double x)
    {
      return x * x;
    }

    template <int dim>
    DualNumber<dim> arc_tangent(const Arguments<dim> &a)
    {
      const double y = a[0].value, x = a[1].value, norm_square = x * x + y * y;
      return {std::atan2(y, x), (x * a[0].gradient - y * a[1].gradient) / norm_square};
    }

    template <int dim>
    DualNumber<dim> largest(const Arguments<dim> &a)
    {
      DualNumber<dim> result = a[0];
      for (std::size_t i = 1; i < a.size(); ++i)
        result = larger(result, a[i]);
      return result;
    }

    template <int dim>
    DualNumber<dim> smallest(const Arguments<dim> &a)
    {
      DualNumber<dim> result = a[0];
      for (std::size_t i = 1; i < a.size(); ++i)
        result = -larger(-result, -a[i]);
      return result;
    }

    template <int dim>
    DualNumber<dim> sum(const Arguments<dim> &a)
    {
      DualNumber<dim> result;
      for (const DualNumber<dim> &argument : a)
        result = result + argument;
      return result;
    }

    template <int dim>
    DualNumber<dim> average(const Arguments<dim> &a)
    {
      return sum(a) / DualNumber<dim>{static_cast<double>(a.size()), {}};
    }
  } // namespace


// One argument x: the value and the derivative.
#define ONE(name, f, derivative)                                                                   \
  {                                                                                                \
    name, [](const Arguments<dim> &a) {                                                            \
      const double x = a[0].value;                                                                 \
      return chain_rule(a[0], f, derivative);                                                      \
    }                                                                                              \
  }

  template <int dim>
  const std::map<std::string, DifferentiableFunction<dim>> &differentiable_functions()
  {
    static const std::map<std::string, DifferentiableFunction<dim>> functions{
      ONE("sin", std::sin(x), std::cos(x)),
      ONE("cos", std::cos(x), -std::sin(x)),
      ONE("tan", std::tan(x), 1. / square(std::cos(x))),
      ONE("cot", 1. / std::tan(x), -1. / square(std::sin(x))),
      ONE("sec", 1. / std::cos(x), std::sin(x) / square(std::cos(x))),
      ONE("csc", 1. / std::sin(x), -std::cos(x) / square(std::sin(x))),
      ONE("asin", std::asin(x), 1. / std::sqrt(1. - x * x)),
      ONE("acos", std::acos(x), -1. / std::sqrt(1. - x * x)),
      ONE("atan", std::atan(x), 1. / (1. + x * x)),
      ONE("sinh", std::sinh(x), std::cosh(x)),
      ONE("cosh", std::cosh(x), std::sinh(x)),
      ONE("tanh", std::tanh(x), 1. / square(std::cosh(x))),
      ONE("asinh", std::asinh(x), 1. / std::sqrt(x * x + 1.)),
      ONE("acosh", std::acosh(x), 1. / std::sqrt(x * x - 1.)),
      ONE("atanh", std::atanh(x), 1. / (1. - x * x)),
      ONE("exp", std::exp(x), std::exp(x)),
      ONE("log", std::log(x), 1. / x),
      ONE("ln", std::log(x), 1. / x),
      ONE("log2", std::log2(x), 1. / (x * std::log(2.))),
      ONE("log10", std::log10(x), 1. / (x * std::log(10.))),
      ONE("sqrt", std::sqrt(x), 0.5 / std::sqrt(x)),
      ONE("erf", std::erf(x), 2. / std::sqrt(PI) * std::exp(-x * x)),
      ONE("erfc", std::erfc(x), -2. / std::sqrt(PI) * std::exp(-x * x)),
      ONE("abs", std::abs(x), sign(x)),
      ONE("sign", sign(x), zero(x)),
      ONE("rint", std::floor(x + 0.5), zero(x)),
      ONE("int", rounded_half_away(x), zero(x)),
      ONE("ceil", std::ceil(x), zero(x)),
      ONE("floor", std::floor(x), zero(x)),
      {"atan2", arc_tangent<dim>},
      {"pow", [](const Arguments<dim> &a) { return power(a[0], a[1]); }},
      {"if",
       [](const Arguments<dim> &a) { return rounded_half_away(a[0].value) != 0. ? a[1] : a[2]; }},
      {"max", largest<dim>},
      {"min", smallest<dim>},
      {"sum", sum<dim>},
      {"avg", average<dim>}};
    return functions;
  }
#undef ONE

  template const std::map<std::string, DifferentiableFunction<2>> &differentiable_functions();
  template const std::map<std::string, DifferentiableFunction<3>> &differentiable_functions();
} // namespace signorini
