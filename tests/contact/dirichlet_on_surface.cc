// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Where the displacement along the normal is prescribed, contact has nothing to decide and the node
// leaves the contact surface; a prescribed tangential displacement leaves the node in.

#include "contact_scene.h"

#include <signorini/base/user_error.h>

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

// A node meets an obstacle that is oblique to prescribed directions in the free ones: its distance
// is that of the place to which the condition and the free motion bring it, and its force that of
// the obstacle, along the unit normal. Only a motion of the condition itself is refused.
TEST(DirichletOnSurface, ObliqueObstacle)
{
  const dealii::Tensor<1, 3> slope({0.1, 0., 1.});
  for (const std::array<std::string, 3> &condition : {std::array<std::string, 3>{{"0", "-", "-"}},
                                                      {{"0.3", "-", "-"}},
                                                      {{"-", "-", "-0.2"}},
                                                      {{"0.3", "0.1", "-"}}})
    {
      SCOPED_TRACE(condition[0] + ";" + condition[1] + ";" + condition[2]);
      Scene<3> scene  = held_box(condition);
      scene.obstacles = {plane<3>("slope", dealii::Point<3>(0., 0., -1.), slope)};
      const ContactProblem<3> problem(scene);
      EXPECT_EQ(problem.surface.n_global_nodes(), 9u);
      EXPECT_EQ(problem.surface.notes().size(), 1u);

      std::array<std::string, 3> motion = {{"0.1*y", "z-x", "-0.3"}};
      for (unsigned int c = 0; c < 3; ++c)
        if (condition[c] != "-")
          motion[c] = condition[c];
      const Vector u         = field<3>(problem.discretization, motion);
      const auto   distance  = problem.surface.distance(u);
      unsigned int n_oblique = 0;
      for (unsigned int k = 0; k < distance.size(); ++k)
        {
          const ContactNode<3> &node  = problem.surface.nodes()[k];
          dealii::Point<3>      place = node.position;
          for (unsigned int c = 0; c < 3; ++c)
            place[c] += u.local_element(3 * node.node + c);
          const auto projection = scene.obstacles[0].shape->project(place);
          EXPECT_LT((node.surface_normal() - projection.normal).norm(), 1e-14);
          if (node.position[0] > 0.)
            continue; // nodes that are not prescribed
          ++n_oblique;
          EXPECT_NEAR(distance[k], projection.gap, 1e-14);
          // A force of 2 along the unit normal is felt with its free part.
          Vector force = problem.discretization.make_vector();
          for (unsigned int c = 0; c < 3; ++c)
            if (condition[c] == "-")
              force.local_element(3 * node.node + c) = -2. * projection.normal[c];
          EXPECT_NEAR(node.normal_force(force), -2., 1e-14);
        }
      EXPECT_EQ(dealii::Utilities::MPI::sum(n_oblique, MPI_COMM_WORLD), 3u);
    }
}

TEST(DirichletOnSurface, ObliqueObstacleAndMotion)
{
  const dealii::Tensor<1, 3> slope({0.1, 0., 1.});
  Scene<3>                   scene = held_box({{"0", "-", "0"}});
  scene.obstacles                  = {plane<3>("slope", dealii::Point<3>(0., 0., -1.), slope)};
  EXPECT_EQ(ContactProblem<3>(scene).surface.n_global_nodes(), 6u) << "the normal is prescribed";
  scene.bodies[0].dirichlet[0].expressions = {{"0.1*t", "-", "-"}};
  try
    {
      const ContactProblem<3> problem(scene);
      FAIL() << "the gap would open and close by itself";
    }
  catch (const UserError &error)
    {
      for (const char *const part : {"Dirichlet", "slope", "in x", "oblique"})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  scene.bodies[0].dirichlet[0].expressions = {{"-", "0.1*t", "-"}};
  EXPECT_EQ(ContactProblem<3>(scene).surface.n_global_nodes(), 9u) << "across the normal";
}
