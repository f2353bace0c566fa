// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Momentum and angular momentum of rigid motions are those of rigid bodies: position and velocity
// are linear and thus in the space of the finite elements, so that the integrals are exact, with
// hanging nodes, too.

#include "../discretization/bodies.h"

#include <signorini/diagnostics/momentum.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  void expect_momentum(const BodyDescription<dim>         &body,
                       const std::array<std::string, dim> &velocity,
                       const std::array<double, 3>        &linear,
                       const std::array<double, 3>        &angular)
  {
    const Assembled<dim> assembled(body);
    State                state;
    state.velocity        = field<dim>(assembled.discretization, velocity);
    state.momentum        = mass_times(assembled.discretization, state.velocity);
    const Momentum result = momentum(assembled.discretization, state);
    for (unsigned int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(result.linear[c], linear[c], 1e-12) << velocity[0] << " " << c;
        EXPECT_NEAR(result.angular[c], angular[c], 1e-12) << velocity[0] << " " << c;
      }
  }
} // namespace

// Unit cube with mass 2: moments of inertia about the corner int rho x x = 2/3, int rho x y = 1/2.
TEST(Momentum, OfARotatingCube)
{
  for (const auto &body : {box<3>(), box_with_hanging_nodes<3>()})
    {
      expect_momentum<3>(body, {{"-y", "x", "0"}}, {{-1., 1., 0.}}, {{-0.5, -0.5, 4. / 3.}});
      expect_momentum<3>(body, {{"0", "-z", "y"}}, {{0., -1., 1.}}, {{4. / 3., -0.5, -0.5}});
      expect_momentum<3>(body, {{"z", "0", "-x"}}, {{1., 0., -1.}}, {{-0.5, 4. / 3., -0.5}});
    }
}

TEST(Momentum, OfAFlyingSquare)
{
  for (const auto &body : {box<2>(), box_with_hanging_nodes<2>()})
    {
      expect_momentum<2>(body, {{"3", "-5"}}, {{6., -10., 0.}}, {{0., 0., -5. - 3.}});
      expect_momentum<2>(body, {{"-(y - 0.5)", "x - 0.5"}}, {{0., 0., 0.}}, {{0., 0., 1. / 3.}});
    }
}

TEST(Momentum, ResultantSumsUpForces)
{
  const Assembled<2> assembled(box_with_hanging_nodes<2>());
  const Vector       weight =
    mass_times(assembled.discretization, field<2>(assembled.discretization, {{"1", "-10"}}));
  const auto sum = resultant(assembled.discretization, weight);
  EXPECT_NEAR(sum[0], 2., 1e-13);
  EXPECT_NEAR(sum[1], -20., 1e-12);
  EXPECT_EQ(sum[2], 0.);
}
