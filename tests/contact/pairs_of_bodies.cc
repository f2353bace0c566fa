// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Which pairs of bodies are accepted: bodies that are apart never count as overlapping, however
// coarse their curved surfaces are; real overlaps are found at any depth; nodes that two pairs
// share, oblique prescribed directions and masters that no slave node can see are refused with a
// message that says so. All processes say the same.

#include "two_bodies.h"

#include <signorini/base/user_error.h>
#include <signorini/contact/overlap.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;

namespace
{
  BodyDescription<3>
  ball_at(const std::string &name, const Point<3> &centre, const unsigned int refinements)
  {
    BodyDescription<3> body;
    body.name            = name;
    ball_of(body).centre = centre;
    ball_of(body).radius = 1.;
    body.refinements     = refinements;
    body.material        = {500., 0.3, 1.};
    return body;
  }

  /** A cube of side 1 with the middle of its lower face at the given height above a larger one. */
  Scene<3> cubes(const double height)
  {
    return stacked<3>(block<3>("upper", {0., 0., height}, {1., 1., 1. + height}, {{3, 3, 3}}),
                      block<3>("lower", {-0.2, -0.2, -1.}, {1.2, 1.2, 0.}, {{2, 2, 2}}));
  }

  /** The message with which a scene is refused, empty if it is not. */
  template <int dim>
  std::string refusal(const Scene<dim> &scene, const Map<dim> &map = {})
  {
    try
      {
        const MappedAssembled<dim> problem(scene, map);
        check_that_bodies_are_apart(problem.mesh, scene.pairs);
        const DirichletConditions<dim> dirichlet(problem.discretization);
        const ContactSurface<dim>      surface(
          problem.discretization, dirichlet, scene.obstacles, scene.pairs);
        surface.check_initial_gap(problem.discretization.make_vector());
      }
    catch (const UserError &error)
      {
        const auto messages =
          dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, std::string(error.what()));
        for (const std::string &message : messages)
          EXPECT_EQ(message, messages[0]);
        return error.what();
      }
    return "";
  }

  void expect_refusal(const std::string &message, const std::string &part)
  {
    EXPECT_NE(message.find(part), std::string::npos)
      << "'" << message << "' should contain '" << part << "'";
  }
} // namespace

TEST(PairsOfBodies, BallsThatTouchInAPointDoNotOverlapOnAnyMesh)
{
  for (const unsigned int slave : {1, 2})
    for (const unsigned int master : {1, 2, 3})
      for (const double shift : {0., 0.3})
        {
          Scene<3> scene =
            stacked<3>(ball_at("upper", {0., 0., 1.}, slave),
                       ball_at("lower", {shift, 0., -std::sqrt(4. - shift * shift) + 1.}, master));
          scene.pairs[0].slave_boundary_ids = scene.pairs[0].master_boundary_ids = {};
          EXPECT_EQ(refusal<3>(scene), "") << slave << " " << master << " " << shift;
          const TwoBodies<3> problem(scene);
          EXPECT_GT(problem.surface.n_global_nodes(), 0u);
          for (const ContactNode<3> &node : problem.surface.nodes())
            EXPECT_GE(node.gap, 0.);
        }
}

TEST(PairsOfBodies, OverlapsAreFoundAtAnyDepth)
{
  EXPECT_EQ(refusal<3>(cubes(0.)), "");
  for (const double depth : {0.02, 0.05, 0.2, 0.5, 0.9, 1.5})
    expect_refusal(refusal<3>(cubes(-depth)), "overlap at the start");
  Scene<3> fine = cubes(-0.01);
  for (auto &body : fine.bodies)
    body.refinements = 2;
  expect_refusal(refusal<3>(fine), "by 0.01 at");
}

TEST(PairsOfBodies, TinyOverlapsAreTakenToTouch)
{
  const TwoBodies<3> problem(cubes(-1e-3));
  ASSERT_EQ(problem.surface.notes().size(), 1u);
  EXPECT_NE(problem.surface.notes()[0].find("overlap by up to 0.001"), std::string::npos);
  for (const ContactNode<3> &node : problem.surface.nodes())
    EXPECT_EQ(node.gap, 0.);
}

TEST(PairsOfBodies, SurfacesHaveToFaceEachOther)
{
  Scene<3> scene                    = cubes(0.1);
  scene.pairs[0].slave_boundary_ids = {top_id<3>};
  expect_refusal(refusal<3>(scene), "no face of the slave looks at a face of the master");
}

TEST(PairsOfBodies, AMasterMustBeSeenByANode)
{
  const Scene<3> scene =
    stacked<3>(block<3>("upper", {0., 0., 0.}, {3., 3., 3.}, {{1, 1, 1}}),
               block<3>("lower", {1.4, 1.4, -1.}, {1.6, 1.6, 0.}, {{1, 1, 1}}));
  expect_refusal(refusal<3>(scene), "covers so little of the faces of the slave");
}

TEST(PairsOfBodies, AMasterSmallerThanTheSlaveIsNoted)
{
  const Scene<3>     scene = stacked<3>(block<3>("upper", {0., 0., 0.}, {1., 1., 1.}, {{8, 8, 2}}),
                                    block<3>("lower", {0., 0., -1.}, {0.5, 1., 0.}, {{3, 3, 3}}));
  const TwoBodies<3> problem(scene);
  ASSERT_EQ(problem.surface.notes().size(), 1u);
  EXPECT_NE(problem.surface.notes()[0].find("opposite to 50 % of the slave"), std::string::npos);
}

TEST(PairsOfBodies, SharedNodesAreRefused)
{
  Scene<3> scene = cubes(0.);
  scene.bodies.push_back(block<3>("lowest", {-0.2, -0.2, -3.}, {1.2, 1.2, -2.}, {{2, 2, 2}}));
  PairDescription second     = scene.pairs[0];
  second.name                = "lower : upper";
  second.slave               = 1;
  second.slave_boundary_ids  = {top_id<3>};
  second.master              = 0;
  second.master_boundary_ids = {bottom_id<3>};
  Scene<3> both_ways         = scene;
  both_ways.pairs.push_back(second);
  expect_refusal(refusal<3>(both_ways), "share the node at");

  PairDescription same_face = scene.pairs[0];
  same_face.name            = "upper : lowest";
  same_face.master          = 2;
  Scene<3> two_masters      = scene;
  two_masters.pairs.push_back(same_face);
  expect_refusal(refusal<3>(two_masters), "share the node at");
}

TEST(PairsOfBodies, ObliqueDirichletConditionsAreRefusedAndTangentialOnesAreNot)
{
  Scene<3> scene            = cubes(0.);
  scene.bodies[0].dirichlet = {{bottom_id<3>, {{"-", "0", "-"}}}};
  EXPECT_EQ(refusal<3>(scene), "");
  expect_refusal(refusal<3>(scene, turn<3>(0.6)), "neither normal nor tangential");

  const TwoBodies<3> slightly_turned(scene, turn<3>(0.2));
  ASSERT_EQ(slightly_turned.surface.notes().size(), 1u);
  EXPECT_NE(slightly_turned.surface.notes()[0].find("degrees"), std::string::npos);
}
