// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The coupled equations of the impulses of laursen-love: their solution fulfils them and is the
// minimum of a convex function, one node alone knows only one way to get its energy back, and where
// the equations cannot be solved the step says so and the energy is right.

#include <signorini/schemes/node_impulses.h>

#include <gtest/gtest.h>

#include <random>

#include "driven_scenes.h"

using namespace signorini;

namespace
{
  /**
   * All nodes of a bar are contact nodes and share its consistent mass; lengths of elements differ
   * by a factor of ten.
   */
  class Patch : public ElasticBar
  {
  public:
    explicit Patch(const unsigned int n)
      : ElasticBar(n)
    {
      mass.setZero();
      for (unsigned int i = 0; i + 1 < n; ++i)
        mass.block<2, 2>(i, i) += Eigen::Matrix2d{{2., 1.}, {1., 2.}} / 6. * (i % 3 ? 0.3 : 3.);
    }

    NormalGap relative_normal(const Vector &motion) const override
    {
      return NormalGap(motion.begin(), motion.begin() + motion.locally_owned_size());
    }

    Vector normal_forces(const std::vector<double> &forces) const override
    {
      Vector result = make_vector();
      std::copy(forces.begin(), forces.end(), result.begin());
      return result;
    }
  };

  /** A bar whose nodal forces are never twice the same. */
  class Unreliable : public ElasticBar
  {
  public:
    using ElasticBar::ElasticBar;

    Vector normal_forces(const std::vector<double> &forces) const override
    {
      Vector result = ElasticBar::normal_forces(forces);
      result *= 1. + 1e-3 * (random() % 10);
      return result;
    }

  private:
    mutable std::mt19937 random;
  };
} // namespace

TEST(NodeImpulses, SolveTheEquations)
{
  std::mt19937                           generator(7);
  std::uniform_real_distribution<double> unit(0., 1.);
  for (const unsigned int n : {2, 3, 10, 60})
    for (unsigned int trial = 0; trial < 20; ++trial)
      {
        Patch               system(n);
        std::vector<double> force(n), gap(n), approach(n);
        for (unsigned int p = 0; p < n; ++p)
          {
            force[p]    = p % 4 == 3 ? 0. : unit(generator);
            gap[p]      = p % 3 == 1 ? 0. : unit(generator);
            approach[p] = unit(generator) - 0.3;
          }
        const NodeImpulses result = solve_node_impulses(system, {force, gap, approach});
        ASSERT_TRUE(result.converged) << n << " nodes, trial " << trial;
        const NormalGap change = system.relative_normal(
          system.solve_mass(system.capabilities().impulses->normal_forces(result.impulses)));
        for (unsigned int p = 0; p < n; ++p)
          {
            const double impulse = result.impulses[p], velocity = change[p] / 2. - approach[p];
            ASSERT_GE(impulse, 0.);
            if (force[p] == 0.)
              {
                ASSERT_EQ(impulse, 0.);
                continue;
              }
            ASSERT_NEAR(impulse * velocity, force[p] * gap[p], 1e-8);
            ASSERT_GE(velocity, -1e-8) << "the minimum: nothing is gained by a larger impulse";
          }
      }
}

TEST(NodeImpulses, OfASingleNodeAreTheCommonOnes)
{
  SchemeParameters parameters;
  parameters.impulses_per_node = false;
  const auto common            = make_time_scheme("laursen-love", parameters),
             per_node          = make_time_scheme("laursen-love");
  auto [system, state]         = make_scene("mass_on_spring");
  State other                  = state;
  for (unsigned int step = 0; step < 100; ++step)
    {
      common->advance(*system, state, 0.04);
      per_node->advance(*system, other, 0.04);
      ASSERT_NEAR(state.displacement(0), other.displacement(0), 1e-10);
      ASSERT_NEAR(state.velocity(0), other.velocity(0), 1e-10);
      ASSERT_NEAR(state.contact_force(0), other.contact_force(0), 1e-8);
    }
}

TEST(NodeImpulses, FailureIsReportedAndTheEnergyIsRight)
{
  Unreliable system(6);
  Vector     v      = system.make_vector();
  v                 = 1.;
  State    state    = make_state(system, system.make_vector(), v);
  double   before   = energy(system, state);
  unsigned n_failed = 0;
  for (unsigned int step = 0; step < 60; ++step)
    {
      const StepReport report = make_time_scheme("laursen-love")->advance(system, state, 0.04);
      n_failed += report.common_impulses;
      ASSERT_NEAR(energy(system, state), before, 1e-11) << "step " << step;
    }
  EXPECT_GT(n_failed, 0u);
}
