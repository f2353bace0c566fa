// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The nodal forces of a load have its resultant, mass times a constant body force and area times a
// constant traction, because the shape functions sum up to one; so they do work like the load on
// every rigid motion. They follow the time.

#include "bodies.h"

#include <signorini/discretization/loads.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  void expect_resultant(const Discretization<dim>    &discretization,
                        const Vector                 &forces,
                        const dealii::Tensor<1, dim> &expected)
  {
    for (unsigned int c = 0; c < dim; ++c)
      EXPECT_NEAR(sum_over_nodes(
                    discretization,
                    [&](const unsigned int node) { return forces.local_element(dim * node + c); }),
                  expected[c],
                  1e-12)
        << "component " << c;
  }
} // namespace

TEST(Loads, NoneIsNone)
{
  const Assembled<2> assembled(box<2>());
  EXPECT_FALSE(Loads<2>(assembled.discretization).any());
}

TEST(Loads, GravityWeighs)
{
  BodyDescription<3> body = ball<3>(1);
  body.local_refinements  = 1;
  body.refine_where       = "0.7 - z";
  body.body_force         = {{"0", "1", "-9.81"}};
  const Assembled<3> assembled(body);
  Loads<3>           loads(assembled.discretization);
  const double       mass = total_mass(assembled.discretization);
  EXPECT_TRUE(loads.any());
  expect_resultant<3>(
    assembled.discretization, loads.at(0.), dealii::Tensor<1, 3>({0., mass, -9.81 * mass}));
}

TEST(Loads, TractionPullsOnItsFaceOnly)
{
  BodyDescription<3> body   = box_with_hanging_nodes<3>();
  box_of(body).upper_corner = dealii::Point<3>(1., 2., 3.);
  body.traction             = {{4, {{"3", "-", "-2"}}}};
  const Assembled<3> assembled(body);
  Loads<3>           loads(assembled.discretization);
  expect_resultant<3>(assembled.discretization, loads.at(0.), dealii::Tensor<1, 3>({6., 0., -4.}));

  // The moment about the corner: the resultant acts in the middle (1/2, 1, 0) of the face.
  const Vector turn = field<3>(assembled.discretization, {{"-y", "x", "0"}});
  EXPECT_NEAR(turn * loads.at(0.), -6., 1e-12);
  for (unsigned int node = 0; node < assembled.discretization.matrices().pattern.n_owned; ++node)
    if (assembled.discretization.node_positions()[node][2] > 0.)
      {
        EXPECT_NEAR(loads.at(0.).local_element(3 * node), 0., 1e-14);
      }
}

TEST(Loads, LinearTractionActsInItsCentreOfPressure)
{
  BodyDescription<2> body = box<2>();
  body.traction           = {{1, {{"y", "0"}}}};
  const Assembled<2> assembled(body);
  Loads<2>           loads(assembled.discretization);
  expect_resultant<2>(assembled.discretization, loads.at(0.), dealii::Tensor<1, 2>({0.5, 0.}));
  EXPECT_NEAR(field<2>(assembled.discretization, {{"-y", "x"}}) * loads.at(0.), -1. / 3., 1e-13);
}

TEST(Loads, FollowTheTimeInAnyOrder)
{
  BodyDescription<2> body = box<2>();
  body.body_force         = {{"2*t", "0"}};
  body.traction           = {{3, {{"0", "t*t"}}}};
  const Assembled<2> assembled(body);
  Loads<2>           loads(assembled.discretization);
  for (const double time : {0., 1., 2., 1., 3., 3., 0.})
    expect_resultant<2>(assembled.discretization,
                        loads.at(time),
                        dealii::Tensor<1, 2>({2. * 2. * time, time * time}));
}

// Whoever holds the load of the start of a step may still use it after asking for that of its end.
TEST(Loads, TwoTimesAreValidTogether)
{
  BodyDescription<2> body = box<2>();
  body.body_force         = {{"t", "0"}};
  const Assembled<2> assembled(body);
  Loads<2>           loads(assembled.discretization);
  const Vector      &start = loads.at(1.);
  const Vector      &end   = loads.at(2.);
  expect_resultant<2>(assembled.discretization, start, dealii::Tensor<1, 2>({2., 0.}));
  expect_resultant<2>(assembled.discretization, end, dealii::Tensor<1, 2>({4., 0.}));
}
