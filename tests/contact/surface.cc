// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The contact surface: unconstrained nodes that face the obstacle, with their distance to it, and
// with weights that share out the area of the surface completely, also where hanging nodes give
// their part away. Each node belongs to its closest obstacle.

#include "contact_scene.h"

#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** The complaint about penetration at the start, or nothing. */
  template <int dim>
  std::string complaint(const ContactProblem<dim> &problem, const Vector &displacement)
  {
    try
      {
        problem.surface.check_initial_gap(displacement);
      }
    catch (const UserError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(ContactSurface, WeightsSumUpToTheFace)
{
  BodyDescription<3> body   = box<3>();
  box_of(body).upper_corner = Point<3>(1., 2., 3.);
  const ContactProblem<3> problem(contact_scene<3>(body, {floor_at<3>(-0.5)}, {4}));
  EXPECT_EQ(problem.surface.n_global_nodes(), 9u);
  EXPECT_NEAR(problem.area(), 2., 1e-14);
  for (const ContactNode<3> &node : problem.surface.nodes())
    {
      EXPECT_EQ(node.position[2], 0.);
      EXPECT_DOUBLE_EQ(node.gap, 0.5);
      EXPECT_EQ(node.normal(), (Tensor<1, 3>({0., 0., -1.})));
      const bool edge_x = node.position[0] != 0.5, edge_y = node.position[1] != 1.;
      EXPECT_NEAR(node.weight, 0.5 / (edge_x ? 2. : 1.) / (edge_y ? 2. : 1.), 1e-14)
        << node.position;
    }
}

TEST(ContactSurface, HangingNodesGiveTheirShareAway)
{
  const ContactProblem<3> problem(
    contact_scene<3>(box_with_hanging_nodes<3>(), {floor_at<3>(0.)}, {4}));
  const auto &discretization = problem.discretization;
  EXPECT_NEAR(problem.area(), 1., 1e-14);
  for (const ContactNode<3> &node : problem.surface.nodes())
    EXPECT_FALSE(discretization.hanging_node_constraints().is_constrained(
      discretization.locally_owned().nth_index_in_set(3 * node.node)))
      << node.position;
  const double n_on_face = sum_over_nodes(discretization, [&](const unsigned int node) {
    return discretization.node_positions()[node][2] == 0. ? 1. : 0.;
  });
  EXPECT_LT(problem.surface.n_global_nodes(), n_on_face);
}

TEST(ContactSurface, OfADiscIsItsPolygon)
{
  const ContactProblem<2> problem(contact_scene<2>(ball<2>(3), {sphere<2>({0., 1.}, 1.5, true)}));
  EXPECT_EQ(problem.surface.n_global_nodes(), 32u);
  EXPECT_NEAR(problem.area(), 32. * 2. * std::sin(dealii::numbers::PI / 32.), 1e-12);
  for (const ContactNode<2> &node : problem.surface.nodes())
    {
      EXPECT_NEAR(node.gap, 0.5, 1e-14);
      EXPECT_LT((node.normal() - (node.position - Point<2>(0., 1.))).norm(), 1e-14);
    }
}

TEST(ContactSurface, NodesThatFaceAwayAreNotOnIt)
{
  const ContactProblem<2> disc(contact_scene<2>(ball<2>(3), {floor_at<2>(0.)}));
  EXPECT_EQ(disc.surface.n_global_nodes(), 15u) << "half of 32 without the two equators";
  for (const ContactNode<2> &node : disc.surface.nodes())
    {
      EXPECT_LT(node.position[1], 0.99);
      EXPECT_NEAR(node.gap, node.position[1], 1e-15);
    }

  const ContactProblem<3> cube(contact_scene<3>(box<3>(), {floor_at<3>(0.)}));
  EXPECT_EQ(cube.surface.n_global_nodes(), 9u) << "the bottom with its edges, no side";
  for (const ContactNode<3> &node : cube.surface.nodes())
    EXPECT_EQ(node.position[2], 0.);
}

TEST(ContactSurface, ClosestObstacleWins)
{
  // A floor 0.2 below the box, and a wall 0.1 to its left: the common corner belongs to the wall.
  const auto              wall = plane<2>("wall", Point<2>(-0.1, 0.), Tensor<1, 2>({1., 0.}));
  const ContactProblem<2> problem(contact_scene<2>(box<2>(), {floor_at<2>(-0.2), wall}));
  EXPECT_EQ(problem.surface.n_global_nodes(), 5u);
  for (const ContactNode<2> &node : problem.surface.nodes())
    {
      const bool at_wall = node.position[0] == 0.;
      EXPECT_EQ(node.pair, at_wall ? 1u : 0u) << node.position;
      EXPECT_NEAR(node.gap, at_wall ? 0.1 : 0.2, 1e-15) << node.position;
      EXPECT_EQ(node.normal(), at_wall ? (Tensor<1, 2>({-1., 0.})) : (Tensor<1, 2>({0., -1.})));
    }
}

TEST(ContactSurface, GapFollowsTheDisplacement)
{
  const ContactProblem<2> problem(contact_scene<2>(box<2>(), {floor_at<2>(-0.2)}, {2}));
  const auto              gap =
    problem.surface.normal_gap(field<2>(problem.discretization, {{"7", "0.1*x - 0.2"}}));
  ASSERT_EQ(gap.size(), problem.surface.nodes().size());
  for (unsigned int k = 0; k < gap.size(); ++k)
    EXPECT_NEAR(gap[k], 0.1 * problem.surface.nodes()[k].position[0], 1e-15);
}

TEST(ContactSurface, PenetrationAtTheStartIsRefused)
{
  const ContactProblem<3> apart(contact_scene<3>(box<3>(), {floor_at<3>(-0.1)}, {4}));
  EXPECT_EQ(complaint(apart, apart.discretization.make_vector()), "");
  EXPECT_EQ(complaint(apart, field<3>(apart.discretization, {{"0", "0", "-0.1"}})), "")
    << "touching is no penetration";

  const std::string pushed =
    complaint(apart, field<3>(apart.discretization, {{"0", "0", "-0.3*x"}}));
  for (const char *word : {"Contact/Pairs", "'box'", "'floor'", "0.2", "Move"})
    EXPECT_NE(pushed.find(word), std::string::npos) << word << " is not in: " << pushed;

  const ContactProblem<3> inside(contact_scene<3>(box<3>(), {floor_at<3>(0.25)}, {4}));
  EXPECT_NE(complaint(inside, inside.discretization.make_vector()).find("0.25"), std::string::npos);
}
