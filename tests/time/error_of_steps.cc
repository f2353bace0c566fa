// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The estimate of what steps leave open of a contact force has the values that its definition gives
// for simple courses: the square of the step for a smooth force, the delay for a straight one,
// whatever the sizes of the steps; and nothing for a constant one. What a contact leaves of its
// error grows in flight, and makes the next contact come at a wrong time.

#include <signorini/time/error_of_steps.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

using namespace signorini;

namespace
{
  using Force = std::function<double(double)>;

  /** Of steps from the time 0, whose forces belong to their middles. */
  double error(const Force &force, const std::vector<double> &sizes, const double delay = 0.)
  {
    ErrorOfSteps result;
    result.start(0., force(0.));
    double time = 0.;
    for (const double size : sizes)
      {
        const double middle = time + size / 2.;
        result.add({middle, size, delay * size, force(middle)});
        time += size;
      }
    return result.relative_error();
  }

  /** Contacts of the length 1 with flights of one length in between, half sines; the first one is
   *  as strong as the parameter says. */
  Force bounces(const unsigned int n, const double flight, const double first = 1.)
  {
    return [=](const double t) {
      const double begin = std::floor(t / (1. + flight)) * (1. + flight);
      const double sine  = std::sin(std::acos(-1.) * (t - begin));
      return t < n * (1. + flight) && t < begin + 1. ? (t < 1. ? first : 1.) * sine : 0.;
    };
  }

  std::vector<double> equal(const unsigned int n, const double end)
  {
    return std::vector<double>(n, end / n);
  }
} // namespace

TEST(ErrorOfSteps, SmoothForcesHaveTheSquareOfTheStep)
{
  const double pi   = std::acos(-1.);
  const Force  sine = [&](const double t) { return std::sin(t); };
  for (const unsigned int n : {50, 200})
    EXPECT_NEAR(error(sine, equal(n, 4. * pi)) / std::pow(4. * pi / n, 2), 0.6, 0.01) << n;
}

TEST(ErrorOfSteps, DelayCountsWhereTheForceChanges)
{
  const double              root = std::sqrt(3.); // of the squares of t and of 1 over [0, 1]
  const Force               ramp = [](const double t) { return t; };
  const std::vector<double> sizes(equal(100, 1.));
  EXPECT_NEAR(error(ramp, sizes), 0., 1e-10) << "a straight force";
  EXPECT_NEAR(error(ramp, sizes, 0.5), 0.5 * 0.01 * root, 2e-4);
  EXPECT_EQ(error([](double) { return 3.; }, sizes, 1.), 0.) << "a constant one";
  std::vector<double> unequal;
  for (unsigned int k = 0; k < 40; ++k)
    unequal.push_back(k % 3 == 0 ? 0.04 : 0.01);
  EXPECT_NEAR(error(ramp, unequal), 0., 1e-10) << "steps of any size";
}

TEST(ErrorOfSteps, LongFlightsHideNoKinks)
{
  // Contact begins at 1 and ends at 2, with a kink or a jump. Flights take one long step each.
  const auto press = [](const double t, const double force) {
    return t > 1. && t < 2. ? force : 0.;
  };
  const Force         kinks = [&](const double t) { return press(t, std::min(t - 1., 2. - t)); };
  const Force         jumps = [&](const double t) { return press(t, 1.); };
  std::vector<double> sizes(102, 0.01);
  sizes.front() = sizes.back() = 1.;
  sizes.push_back(1.);
  for (const Force &force : {kinks, jumps})
    EXPECT_NEAR(error(force, sizes) / error(force, equal(400, 4.)), 1., 0.1);
  EXPECT_GT(error(jumps, sizes), 0.05);
  EXPECT_EQ(error([](double) { return 0.; }, sizes), 0.) << "no contact";
}

TEST(ErrorOfSteps, UnitsDoNotMatter)
{
  const auto hump = [](const double unit) {
    return [unit](const double t) { return unit * t * t * (2. - t); };
  };
  EXPECT_DOUBLE_EQ(error(hump(1.), equal(20, 2.)), error(hump(1024.), equal(20, 2.)));
}

TEST(ErrorOfSteps, GrowsInFlight)
{
  const double tau = 0.01;
  const auto   of  = [&](const unsigned int n, const double flight, const double first = 1.) {
    const double end = n * (1. + flight);
    return error(bounces(n, flight, first), equal(std::lround(end / tau), end), 0.5);
  };
  // The delay of half a step is an error of tau/2 * pi of the force, and 0.15 of it one of the
  // speed. In a flight of the length 10 the next contact becomes late by that, times pi of the
  // force.
  const double pi = std::acos(-1.), own = 0.5 * tau * pi, late = 0.15 * own * 10. * pi;
  EXPECT_NEAR(of(1, 10.), own, 0.05 * own);
  EXPECT_NEAR(of(2, 10.), std::sqrt(own * own + late * late / 2.), 0.1 * late);
  EXPECT_NEAR(of(2, 1.), own, 0.2 * own) << "a short flight";
  EXPECT_GT(of(4, 10.), 2. * of(2, 10.)) << "errors of speeds and of times add up";
  EXPECT_LT(of(2, 1e4), 1.2) << "no more than all of the force";
}

TEST(ErrorOfSteps, ATouchLeavesLittle)
{
  // A hundredth of the impulse, long before the only blow.
  const double blow = error(bounces(1, 10.), equal(1100, 11.), 0.5);
  EXPECT_NEAR(error(bounces(2, 10., 0.01), equal(2200, 22.), 0.5) / blow, 1., 0.05);
}

TEST(ErrorOfSteps, ForcesThatPullCountAsThoseThatPress)
{
  const Force press = bounces(2, 10.);
  const Force pull  = [&](const double t) { return -press(t); };
  EXPECT_EQ(error(pull, equal(2200, 22.), 0.5), error(press, equal(2200, 22.), 0.5));
}
