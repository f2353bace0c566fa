// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A differentiable expression has the value that muParser gives it, for every function, operator
// and order of operators, and the gradient that Richardson's extrapolation of differences of
// muParser's values gives. Kinks have the mean of their sides; what has no derivative is refused.

#include <signorini/base/differentiable_expression.h>
#include <signorini/base/differentiable_functions.h>
#include <signorini/base/expressions.h>
#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

#include <random>

using namespace signorini;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** By differences with steps h and h/2, so that the error is O(h^4). */
  Tensor<1, 3> gradient_by_differences(const dealii::Function<3> &f, const Point<3> &p)
  {
    const auto difference = [&](const unsigned int c, const double h) {
      Tensor<1, 3> step;
      step[c] = h;
      return (f.value(p + step) - f.value(p - step)) / (2. * h);
    };
    Tensor<1, 3> result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = (4. * difference(c, 5e-4) - difference(c, 1e-3)) / 3.;
    return result;
  }

  const std::vector<Point<3>> points{{0.31, 0.47, 0.83}, {0.73, 0.29, 0.57}};

  void expect_as_muparser(const std::string &text, const std::vector<Point<3>> &where = points)
  {
    const DifferentiableExpression<3> expression(text);
    const auto                        muparser = make_function<3, 1>({{text}});
    for (const Point<3> &p : where)
      {
        const auto found = expression(p);
        EXPECT_NEAR(found.value, muparser->value(p), 1e-14 * (1. + std::abs(found.value))) << text;
        EXPECT_LT((found.gradient - gradient_by_differences(*muparser, p)).norm(),
                  1e-8 * (1. + found.gradient.norm()))
          << text << " at " << p << ": " << found.gradient;
      }
  }

  /**
   * A random expression. It is without && and ||, for which muParser cuts constants, but no other
   * numbers, to integers.
   */
  std::string random_expression(std::mt19937 &random, const unsigned int depth)
  {
    static const std::vector<std::string> leaves{"x", "y", "z", "1.5", "2", "pi", "0.25", ".5e0"},
      operators{"+", "-", "*", " / ", "^", "<", ">", "+ -", "*-", " | ", " & "},
      calls{"sin", "exp", "-", "", "+", "cosh", "atan"};
    const auto choose = [&](const std::vector<std::string> &list) {
      return list[random() % list.size()];
    };
    if (depth == 0)
      return choose(leaves);
    switch (random() % 6)
      {
      case 0:
        return "(" + choose(calls) + "(" + random_expression(random, depth - 1) + "))";
      case 1:
        return "(" + random_expression(random, depth - 1) + " ? "
               + random_expression(random, depth - 1) + " : " + random_expression(random, depth - 1)
               + ")";
      default:
        return random_expression(random, depth - 1) + choose(operators)
               + random_expression(random, depth - 1);
      }
  }
} // namespace

TEST(DifferentiableExpression, FunctionsOfOneArgument)
{
  for (const std::string name :
       {"sin",  "cos",   "tan",  "cot",   "sec",   "csc",  "asin", "acos", "atan",
        "sinh", "cosh",  "tanh", "asinh", "atanh", "exp",  "log",  "ln",   "log2",
        "sqrt", "log10", "erfc", "abs",   "sign",  "rint", "int",  "ceil", "floor"})
    for (const std::string argument : {"x", "x*y - 0.05*z", "0.2 + x^2"})
      expect_as_muparser(name + "(" + argument + ")");
  expect_as_muparser("acosh(1 + x + y)");
  // Since which version dealii::FunctionParser knows the error function is not known here.
  EXPECT_NEAR(DifferentiableExpression<2>("erf(x) + erfc(x)")({0.3, 0.}).gradient[0], 0., 1e-15);
}

TEST(DifferentiableExpression, FunctionsOfSeveralArguments)
{
  for (const std::string text : {"atan2(y, x)",
                                 "pow(x, 2.5)",
                                 "pow (x, y)",
                                 "if(x < 0.5, x*y, y*z)",
                                 "if(x < 0.5 & y < 0.4, x*y, y*z)",
                                 "max(x, y, z)",
                                 "min(x*2, y, z)",
                                 "sum(x, 2*y, z^2)",
                                 "avg(x, y*y)",
                                 "_e^x"})
    expect_as_muparser(text);
  // muParser 2.3.3 has only 13 digits of this constant.
  EXPECT_NEAR(DifferentiableExpression<3>("sin(_pi)")(Point<3>()).value, 0., 1e-15);
}

TEST(DifferentiableExpression, OrderOfOperators)
{
  for (const std::string text : {"-x^2",
                                 "2^-x",
                                 "2^-x^2*y",
                                 "x^y^z",
                                 "x - y - z",
                                 "x/y/z",
                                 "x/y*z",
                                 "-x*-y",
                                 "x - -y + z",
                                 "x + y*z^2",
                                 "x < y < z",
                                 "x < y == y < z",
                                 "x*y < z",
                                 "x < y || y < z && z < x",
                                 "x < y | y < z & z < x",
                                 "x < y ? x : y < z ? y : z",
                                 "(x < y ? x : y)*z",
                                 "1e-1*x + 2.E1*y + .5*z",
                                 "x != y",
                                 "x >= y",
                                 "x <= y",
                                 "\tx +\ny ",
                                 "sin (x)",
                                 "+x"})
    expect_as_muparser(text);
}

TEST(DifferentiableExpression, RandomExpressions)
{
  std::mt19937 random(1);
  unsigned int n_compared = 0;
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const std::string                 text = random_expression(random, 3);
      const DifferentiableExpression<3> expression(text);
      const auto                        muparser = make_function<3, 1>({{text}});
      for (const Point<3> &p : points)
        {
          const double expected = muparser->value(p), found = expression(p).value;
          if (!std::isfinite(expected) || std::abs(expected) > 1e6)
            continue;
          ++n_compared;
          EXPECT_NEAR(found, expected, 1e-10 * (1. + std::abs(expected))) << text << " at " << p;
        }
    }
  EXPECT_GT(n_compared, 2000u);
}

TEST(DifferentiableExpression, KinksHaveTheMeanOfTheirSides)
{
  const Point<2> tip(0., 0.);
  EXPECT_EQ(DifferentiableExpression<2>("y + abs(x)")(tip).gradient, (Tensor<1, 2>({0., 1.})));
  EXPECT_EQ(DifferentiableExpression<2>("max(x, y)")(tip).gradient, (Tensor<1, 2>({0.5, 0.5})));
  EXPECT_EQ(DifferentiableExpression<2>("min(2*x, y)")(tip).gradient, (Tensor<1, 2>({1., 0.5})));
  EXPECT_EQ(DifferentiableExpression<2>("sqrt(x*x)")(tip).gradient, (Tensor<1, 2>()));
}

TEST(DifferentiableExpression, PowersAtZero)
{
  const Point<2> origin(0., 0.);
  for (const auto &[text, slope] : std::vector<std::pair<std::string, double>>{
         {"x^0", 0.}, {"x^1", 1.}, {"x^2", 0.}, {"x^1.5", 0.}, {"0*x^3", 0.}})
    EXPECT_EQ(DifferentiableExpression<2>(text)(origin).gradient[0], slope) << text;
  EXPECT_TRUE(std::isinf(DifferentiableExpression<2>("x^0.5")(origin).gradient[0]));
  EXPECT_TRUE(std::isinf(DifferentiableExpression<2>("sqrt(x)")(origin).gradient[0]));
}

TEST(DifferentiableExpression, WhatHasNoDerivativeIsRefused)
{
  const auto message = [](const std::string &text) {
    try
      {
        DifferentiableExpression<2>{text};
      }
    catch (const UserError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  EXPECT_EQ(message("y - rand()"), "the function `rand` has no derivative");
  EXPECT_EQ(message("y - rand_seed(3)"), "the function `rand_seed` has no derivative");
  EXPECT_EQ(message("y = 3"), "`= 3` is an assignment, which has no derivative");
  EXPECT_EQ(message("y*2 # x"), "`# x` has no known derivative");
}
