// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Where the displacement along the normal is prescribed, contact has nothing to decide and the node
// leaves the contact surface; a prescribed tangential displacement leaves the node in.

#include "contact_scene.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** A box with 3 x 3 nodes on its contact face z = 0; those at x = 0 are prescribed. */
  Scene<3> held_box(const std::array<std::string, 3> &expressions)
  {
    BodyDescription<3> body = box<3>();
    body.dirichlet          = {{0, expressions}};
    return contact_scene<3>(body, {floor_at<3>(-0.1)}, {4});
  }
} // namespace

TEST(DirichletOnSurface, NormalConditionTakesTheNode)
{
  const ContactProblem<3> problem(held_box({{"-", "-", "0"}}));
  EXPECT_EQ(problem.surface.n_global_nodes(), 6u);
  EXPECT_EQ(problem.surface.n_left_to_dirichlet_conditions(), 3u);
  for (const ContactNode<3> &node : problem.surface.nodes())
    EXPECT_GT(node.position[0], 0.);
}

TEST(DirichletOnSurface, TangentialConditionLeavesTheNode)
{
  const ContactProblem<3> problem(held_box({{"0", "0", "-"}}));
  EXPECT_EQ(problem.surface.n_global_nodes(), 9u);
  EXPECT_EQ(problem.surface.n_left_to_dirichlet_conditions(), 0u);
  for (const ContactNode<3> &node : problem.surface.nodes())
    EXPECT_EQ(node.frame[2], -1.);
}

TEST(DirichletOnSurface, ObliqueObstacle)
{
  // The normal has components in x and z: prescribing x or z takes the node, prescribing y does
  // not.
  Scene<3> scene  = held_box({{"-", "0", "-"}});
  scene.obstacles = {
    plane<3>("slope", dealii::Point<3>(0., 0., -1.), dealii::Tensor<1, 3>({0.1, 0., 1.}))};
  EXPECT_EQ(ContactProblem<3>(scene).surface.n_global_nodes(), 9u);
  scene.bodies[0].dirichlet[0].expressions = {{"0", "-", "-"}};
  EXPECT_EQ(ContactProblem<3>(scene).surface.n_global_nodes(), 6u);
  scene.bodies[0].dirichlet[0].expressions = {{"-", "-", "0"}};
  EXPECT_EQ(ContactProblem<3>(scene).surface.n_global_nodes(), 6u);
}
