// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The bar that hits a wall with a single contact node: the impulses of laursen-love give energy
// back exactly and make the total contact force constant, 1.92 times too large only in the first
// step. Two contact nodes that share one impulse do not do that (doc/schemes.md).

#include <gtest/gtest.h>

#include "bouncing_mass.h"
#include "elastic_bar.h"

using namespace signorini;

TEST(OneContactNode, LaursenAndLoveHaveASmoothForce)
{
  // 100 elements, Courant number 0.9, speed 1/3 of that of waves; touch at 1.5, release at 3.5.
  constexpr double tau = 0.009, speed = 1. / 3.;
  ElasticBar       system(101);
  system.distance      = {{0.5, 10.}};
  Vector v             = system.make_vector();
  v                    = -speed;
  State        state   = make_state(system, system.make_vector(), v);
  const auto   scheme  = make_time_scheme("laursen-love");
  const double initial = energy(system, state);

  double       largest = 0., sum = 0., squares = 0.;
  unsigned int n = 0;
  while (state.time < 6.)
    {
      scheme->advance(system, state, tau);
      ASSERT_NEAR(energy(system, state), initial, 1e-10 * initial);
      ASSERT_GE(system.normal_gap(state.displacement)[0], -1e-12);
      const double pressure = state.contact_force(0) / speed; // exact: 1
      largest               = std::max(largest, pressure);
      if (state.time > 1.7 && state.time < 3.3)
        {
          sum += pressure;
          squares += pressure * pressure;
          ++n;
        }
    }
  EXPECT_NEAR(largest, 1.92, 0.05 * 1.92);
  EXPECT_NEAR(sum / n, 1., 0.005);
  EXPECT_LT(std::sqrt(squares / n - sum * sum / n / n), 0.002);
}
