// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// When the mesh changes. A number of steps that is given is kept. Else the mesh changes when the
// losses of steps amount to its cost: sooner, the more a step loses; never, if it loses nothing; at
// once, if contact is about to meet coarse cells, or an error comes up that the mesh was not made
// for. It is judged at intervals that never exceed the longest wait.

#include <signorini/adaptivity/remeshing_rule.h>

#include <gtest/gtest.h>

using namespace signorini;

namespace
{
  constexpr unsigned int never = 1000, longest_wait = 2;

  RemeshingRule automatic()
  {
    AdaptivityParameters parameters;
    parameters.indicator = IndicatorKind::residual;
    return RemeshingRule(parameters);
  }

  MeshChange refinement(const double part, const double estimate = 1.)
  {
    MeshChange change;
    change.estimate    = estimate;
    change.n_to_refine = 10;
    change.error_part  = part;
    return change;
  }

  /** Judge the mesh whenever it is due. @return the step after which it changes, at most `never` */
  unsigned int first_change(RemeshingRule rule, const MeshChange &change)
  {
    for (unsigned int step = 1, last = 0; step < never; ++step)
      if (rule.is_due(step))
        {
          EXPECT_LE(step, last + longest_wait);
          last = step;
          if (rule.pays(change, step, longest_wait))
            return step;
        }
    return never;
  }
} // namespace

TEST(RemeshingRule, KeepsAGivenNumberOfSteps)
{
  AdaptivityParameters parameters;
  parameters.indicator     = IndicatorKind::residual;
  parameters.steps_between = 3;
  RemeshingRule rule(parameters);
  for (unsigned int step = 1; step < 20; ++step)
    {
      EXPECT_EQ(rule.is_due(step), step % 3 == 0);
      if (rule.is_due(step))
        {
          EXPECT_TRUE(rule.pays(refinement(1e-3), step, longest_wait));
          rule.mesh_changes(step);
        }
    }
  EXPECT_FALSE(rule.pays(MeshChange(), 21, longest_wait)) << "nothing to change";
}

TEST(RemeshingRule, ChangesTheMeshWhenLossesAmountToTheCost)
{
  EXPECT_LE(first_change(automatic(), refinement(1.)), 3u);
  const unsigned int half = first_change(automatic(), refinement(0.5)),
                     few  = first_change(automatic(), refinement(0.05));
  EXPECT_GE(half, 3u);
  EXPECT_LE(half, 5u);
  EXPECT_GE(few, 36u);
  EXPECT_LE(few, 42u) << "the losses of waits add up";
  MeshChange coarsening;
  coarsening.estimate       = 1.;
  coarsening.n_to_coarsen   = 100;
  coarsening.spared_part    = 0.25;
  const unsigned int spared = first_change(automatic(), coarsening);
  EXPECT_GE(spared, 7u);
  EXPECT_LE(spared, 10u);
}

TEST(RemeshingRule, KeepsAMeshThatIsGoodEnough)
{
  MeshChange nothing;
  nothing.estimate   = 1.;
  nothing.error_part = 0.05; // less than is worth it
  EXPECT_EQ(first_change(automatic(), nothing), never);
}

TEST(RemeshingRule, DoesNotLetContactWait)
{
  MeshChange urgent = refinement(1e-6);
  urgent.is_urgent  = true;
  EXPECT_EQ(first_change(automatic(), urgent), 1u);
}

TEST(RemeshingRule, ReactsToAnErrorThatComesUp)
{
  RemeshingRule rule = automatic();
  EXPECT_FALSE(rule.pays(refinement(0.1, 1.), 1, longest_wait));
  EXPECT_TRUE(rule.pays(refinement(0.1, 10.), 2, longest_wait))
    << "a hundred times the squared estimate";
  // The new mesh has its own measure.
  rule.mesh_changes(2);
  EXPECT_TRUE(rule.is_due(3));
  EXPECT_FALSE(rule.pays(refinement(0.1, 10.), 3, longest_wait));

  RemeshingRule at_rest = automatic();
  EXPECT_FALSE(at_rest.pays(MeshChange(), 1, longest_wait));
  EXPECT_TRUE(at_rest.pays(refinement(0.5, 1e-3), 2, longest_wait))
    << "after flight without any error";
}

TEST(RemeshingRule, JudgesEachStepThatMayBeRepeated)
{
  AdaptivityParameters parameters;
  parameters.indicator   = IndicatorKind::residual;
  parameters.repetitions = 2;
  EXPECT_EQ(first_change(RemeshingRule(parameters), refinement(1e-3)), 1u);
}

TEST(RemeshingRule, ChangesTheMeshBeforeTheFirstStepAtNoCost)
{
  RemeshingRule rule = automatic();
  EXPECT_TRUE(rule.pays(refinement(0.2, 0.), 0, longest_wait));
  rule.mesh_changes(0);
  EXPECT_FALSE(rule.pays(MeshChange(), 0, longest_wait));
  EXPECT_TRUE(rule.is_due(1)) << "its estimate is the first one";
  EXPECT_FALSE(rule.pays(refinement(0.2), 1, longest_wait)) << "and no growth";
}
