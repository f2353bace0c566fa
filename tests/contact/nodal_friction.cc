// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The law of a pair at its nodes: expressions are evaluated where the node is in the reference
// configuration, and stresses become forces of the node. Every pair has its own law; at obstacles
// friction acts, too, but nothing is relative.

#include "two_bodies.h"

#include "contact_scene.h"

#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

#include <limits>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  Scene<2> on_floor(const FrictionDescription &friction)
  {
    Scene<2> scene          = contact_scene<2>(box<2>(), {floor_at<2>(-0.1)}, {2});
    scene.pairs[0].friction = friction;
    return scene;
  }

  Scene<3> two_blocks(const FrictionDescription &friction)
  {
    Scene<3> scene          = stacked<3>(block<3>("upper", {0., 0., 0.}, {1., 1., 1.}, {{3, 2, 1}}),
                                block<3>("lower", {0., 0., -1.}, {1., 1., -0.1}, {{2, 2, 1}}));
    scene.pairs[0].friction = friction;
    return scene;
  }

  std::string refusal(const FrictionDescription &friction)
  {
    try
      {
        const ContactProblem<3> problem(two_blocks(friction));
      }
    catch (const UserError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(NodalFriction, CoefficientVariesInSpace)
{
  const ContactProblem<3> problem(two_blocks({FrictionKind::coulomb, "0.1 + x*y", "", true}));
  EXPECT_EQ(problem.surface.n_global_nodes(), 12u);
  for (const ContactNode<3> &node : problem.surface.nodes())
    {
      EXPECT_NEAR(node.friction.coefficient, 0.1 + node.position[0] * node.position[1], 1e-15);
      EXPECT_EQ(node.friction.constant, 0.);
      EXPECT_EQ(node.friction.cap, infinity);
    }
}

TEST(NodalFriction, BoundsBecomeForces)
{
  const ContactProblem<3> capped(two_blocks({FrictionKind::coulomb, "0.3", "2 + z - x", true})),
    constant(two_blocks({FrictionKind::tresca, "7", "2 + z - x", true}));
  for (const ContactNode<3> &node : capped.surface.nodes())
    {
      EXPECT_EQ(node.friction.coefficient, 0.3);
      EXPECT_EQ(node.friction.constant, 0.);
      EXPECT_NEAR(node.friction.cap, (2. - node.position[0]) * node.weight, 1e-15);
    }
  for (const ContactNode<3> &node : constant.surface.nodes())
    {
      EXPECT_EQ(node.friction.coefficient, 0.) << "no part of this law";
      EXPECT_NEAR(node.friction.constant, (2. - node.position[0]) * node.weight, 1e-15);
      EXPECT_EQ(node.friction.cap, infinity);
    }
}

TEST(NodalFriction, ObstaclesAreNotRelative)
{
  const auto count = [](const FrictionDescription &friction) {
    const ContactProblem<2>     problem(on_floor(friction));
    const ContactCoordinates<2> coordinates(
      problem.discretization, problem.surface, problem.dirichlet);
    EXPECT_TRUE(coordinates.relative_entries().empty());
    unsigned int n = 0;
    for (unsigned int k = 0; k < problem.surface.nodes().size(); ++k)
      {
        const auto &entries = coordinates.tangential_entries()[k];
        n += entries.size();
        for (const unsigned int entry : entries)
          EXPECT_EQ(entry, coordinates.normal_entries()[k] + 1);
      }
    return dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD);
  };
  EXPECT_EQ(count({FrictionKind::coulomb, "0.3", "", true}), 3u);
  EXPECT_EQ(count({FrictionKind::coulomb, "max(0, x - 0.5)", "", true}), 1u)
    << "where there is friction";
  EXPECT_EQ(count({FrictionKind::coulomb, "0", "", false}), 0u);
}

// A stack of three blocks, with friction between the upper two only.
TEST(NodalFriction, BelongsToAPair)
{
  Scene<3> scene = two_blocks({FrictionKind::coulomb, "0.3", "", true});
  scene.bodies.push_back(block<3>("base", {0., 0., -2.}, {1., 1., -1.}, {{2, 1, 1}}));
  PairDescription pair;
  pair.name                = "lower : base";
  pair.slave               = 1;
  pair.slave_boundary_ids  = {bottom_id<3>};
  pair.master              = 2;
  pair.master_boundary_ids = {top_id<3>};
  scene.pairs.push_back(pair);
  const TwoBodies<3> bodies(scene);
  EXPECT_EQ(bodies.sum([](const ContactNode<3> &node) { return node.pair == 0; }), 12.);
  EXPECT_EQ(bodies.sum([](const ContactNode<3> &node) { return node.pair == 1; }), 9.);
  for (const ContactNode<3> &node : bodies.surface.nodes())
    {
      EXPECT_EQ(node.friction.coefficient, node.pair == 0 ? 0.3 : 0.);
      const bool first = node.pair == 0;
      EXPECT_EQ(node.relative, (std::array<bool, 3>{{true, first, first}}));
    }
}

TEST(NodalFriction, NegativeValuesAreRefused)
{
  const std::string coefficient = refusal({FrictionKind::coulomb, "0.5 - x", "", true}),
                    bound       = refusal({FrictionKind::tresca, "0", "1/(x - 1)", true});
  EXPECT_NE(coefficient.find("Contact/upper : lower/Friction coefficient = 0.5 - x: this is -"),
            std::string::npos)
    << coefficient;
  EXPECT_NE(bound.find("Contact/upper : lower/Friction bound = 1/(x - 1): this is "),
            std::string::npos)
    << bound;
  EXPECT_EQ(refusal({FrictionKind::coulomb, "1 - x", "1 - y", true}), "") << "zero is allowed";
}
