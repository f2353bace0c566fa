// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Two bodies in any configuration: weights of partners add up to one; the relative position of a
// node is along its normal, and the gap is its length, so that forces have no moment; a rigid
// motion of all turns normals and changes nothing else; the gap of blocks that are moved as a whole
// is the distance of their faces; an edge on a face takes the normal of the face, whichever is
// slave; nothing faces anything where bodies are far apart; and whatever nodes are left without
// multiplier, the others mean by a positive gap that bodies are apart.

#include "two_bodies.h"

#include <signorini/contact/facing_pair.h>
#include <signorini/contact/node_coupling.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  template <int dim>
  struct Facing2
  {
    explicit Facing2(const Scene<dim> &scene)
      : assembled(scene, {})
      , dirichlet(assembled.discretization)
      , pair(assembled.discretization, dirichlet, assembled.scene.pairs, 0)
    {
    }

    /** A displacement of each body, by place. */
    Vector displacement(
      const std::function<Tensor<1, dim>(unsigned int body, const Point<dim> &)> &motion) const
    {
      Vector     result = assembled.discretization.make_vector();
      const auto bodies = assembled.discretization.bodies_of_nodes();
      for (unsigned int node = 0; node < bodies.size(); ++node)
        {
          const auto u = motion(bodies[node], assembled.discretization.node_positions()[node]);
          for (unsigned int c = 0; c < dim; ++c)
            result.local_element(dim * node + c) = u[c];
        }
      return result;
    }

    Vector positions(const Vector &displacement) const
    {
      Vector result = displacement;
      for (unsigned int node = 0; node < assembled.discretization.bodies_of_nodes().size(); ++node)
        for (unsigned int c = 0; c < dim; ++c)
          result.local_element(dim * node + c) +=
            assembled.discretization.node_positions()[node][c];
      return result;
    }

    /** [x] of each node. */
    std::vector<Tensor<1, dim>> relative_positions(const std::vector<ContactNode<dim>> &nodes,
                                                   const Vector &displacement) const
    {
      const Vector            x = positions(displacement);
      const NodeCoupling<dim> coupling(
        nodes, assembled.discretization.matrices().pattern.partitioner, true);
      auto result = coupling.partner_displacement(x);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        for (unsigned int c = 0; c < dim; ++c)
          result[k][c] = x.local_element(dim * nodes[k].node + c) - result[k][c];
      return result;
    }

    MappedAssembled<dim>     assembled;
    DirichletConditions<dim> dirichlet;
    FacingPair<dim>          pair;
  };


  template <int dim>
  unsigned int number(const std::vector<ContactNode<dim>> &nodes)
  {
    return dealii::Utilities::MPI::sum(static_cast<unsigned int>(nodes.size()), MPI_COMM_WORLD);
  }


  /** Two discs or balls that overlap a little, with different meshes. */
  template <int dim>
  Scene<dim> round_bodies()
  {
    const auto ball = [](const std::string &name, const double height, const unsigned int level) {
      BodyDescription<dim> body;
      body.name                     = name;
      ball_of(body).centre[dim - 1] = height;
      ball_of(body).radius          = 1.;
      body.refinements              = level;
      body.material                 = {500., 0.3, 1.};
      return body;
    };
    Scene<dim> scene = stacked<dim>(ball("upper", 1., 3), ball("lower", -1., dim == 2 ? 4 : 2));
    scene.pairs[0].slave_boundary_ids.clear();
    scene.pairs[0].master_boundary_ids.clear();
    return scene;
  }


  /** The upper body slides and comes down. */
  template <int dim>
  Tensor<1, dim> slide(const unsigned int body, const Point<dim> &)
  {
    Tensor<1, dim> result;
    if (body == 0)
      {
        result[0]       = 0.13;
        result[dim - 1] = -0.02;
      }
    return result;
  }


  template <int dim>
  void expect_aligned()
  {
    const Facing2<dim> two(round_bodies<dim>());
    const Vector       u        = two.displacement(slide<dim>);
    const auto         nodes    = two.pair.at(u, 0.1);
    const auto         relative = two.relative_positions(nodes, u);
    EXPECT_GT(number(nodes), dim == 2 ? 3u : 8u);
    unsigned int n_aligned = 0, n_near = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        double sum = 0.;
        for (const auto &[partner, weight] : nodes[k].partners)
          sum += weight;
        EXPECT_NEAR(sum, 1., 1e-12);
        EXPECT_NEAR(nodes[k].gap, -(nodes[k].normal() * relative[k]), 1e-13);
        if (nodes[k].gap < 0.02)
          {
            ++n_near;
            n_aligned +=
              (relative[k] - (relative[k] * nodes[k].normal()) * nodes[k].normal()).norm() < 1e-13;
          }
      }
    // A node at whose partners the shift would be too large stays as it is; none does in contact.
    EXPECT_EQ(n_aligned, n_near);
  }


  template <int dim>
  void expect_objective()
  {
    const Facing2<dim> two(round_bodies<dim>());
    const auto         turned = rotation<dim>(0.7);
    const auto         first  = two.pair.at(two.displacement(slide<dim>), 0.1);
    const auto         second =
      two.pair.at(two.displacement([&](const unsigned int body, const Point<dim> &x) {
        return turned * (Tensor<1, dim>(x) + slide<dim>(body, x)) - Tensor<1, dim>(x);
      }),
                  0.1);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t k = 0; k < first.size(); ++k)
      {
        EXPECT_EQ(first[k].node, second[k].node);
        EXPECT_NEAR(first[k].gap, second[k].gap, 1e-12);
        EXPECT_LT((turned * first[k].normal() - second[k].normal()).norm(), 1e-12);
      }
  }


  /** A block of side 1 with its edge or its face on a wide one; @param slave that comes first */
  std::vector<ContactNode<2>> on_edge(const bool edge_is_slave)
  {
    const auto small = block<2>("small", {-0.5, -0.5}, {0.5, 0.5}, {{4, 4}}),
               wide  = block<2>("wide", {-2., -1.}, {2., 0.}, {{10, 3}});
    Scene<2> scene   = edge_is_slave ? stacked<2>(small, wide) : stacked<2>(wide, small);
    scene.pairs[0].slave_boundary_ids.clear();
    scene.pairs[0].master_boundary_ids.clear();
    const Facing2<2> two(scene);
    const auto       turned = rotation<2>(0.7);
    return two.pair.at(two.displacement([&](const unsigned int body, const Point<2> &x) {
      if ((body == 0) != edge_is_slave)
        return Tensor<1, 2>();
      Tensor<1, 2> u = turned * Tensor<1, 2>(x) - Tensor<1, 2>(x);
      u[1] += std::sqrt(0.5) * std::sin(0.7 + std::acos(-1.) / 4.);
      return u;
    }),
                       0.05);
  }
} // namespace


TEST(FacingPair, RelativePositionsAreNormal)
{
  expect_aligned<2>();
  expect_aligned<3>();
}


TEST(FacingPair, ARigidMotionOfAllChangesNothing)
{
  expect_objective<2>();
  expect_objective<3>();
}


TEST(FacingPair, TheGapOfFlatFacesIsTheirDistance)
{
  const Facing2<3> two(stacked<3>(block<3>("upper", {0., 0., 0.1}, {1., 1., 1.}, {{3, 3, 2}}),
                                  block<3>("lower", {-2., -2., -1.}, {2., 2., 0.}, {{5, 7, 2}})));
  const auto nodes = two.pair.at(two.displacement([](const unsigned int body, const Point<3> &) {
    return body == 0 ? Tensor<1, 3>({0.4, -0.3, -0.07}) : Tensor<1, 3>();
  }),
                                 0.1);
  EXPECT_EQ(number(nodes), 16u);
  for (const ContactNode<3> &node : nodes)
    {
      EXPECT_NEAR(node.gap, 0.03, 1e-13);
      EXPECT_NEAR(node.normal()[2], -1., 1e-13);
      EXPECT_NEAR(node.clearance, 0.03, 1e-13);
    }
}


TEST(FacingPair, AnEdgeTakesTheNormalOfTheFace)
{
  // Within the part that equally flat sides share, a hundredth of the angle between the normals.
  for (const bool edge_is_slave : {true, false})
    {
      const auto nodes = on_edge(edge_is_slave);
      EXPECT_GT(number(nodes), 0u);
      for (const ContactNode<2> &node : nodes)
        {
          if (node.gap < 0.05)
            {
              EXPECT_LT(std::abs(node.normal()[0]), 0.05);
            }
        }
    }
}


TEST(FacingPair, WhatIsFarFacesNothing)
{
  const Facing2<2> two(round_bodies<2>());
  const auto       apart = [](const unsigned int body, const Point<2> &) {
    return body == 0 ? Tensor<1, 2>({0., 0.6}) : Tensor<1, 2>();
  };
  EXPECT_EQ(number(two.pair.at(two.displacement(apart), 0.1)), 0u);
}


TEST(FacingPair, NoNodeWidensItsGapWhereBodiesComeCloser)
{
  // A strip of the only slave face is covered, and the two nodes at one of its ends must not carry
  // multipliers. That of the nearer one of the other two would transmit -51 times its own force: it
  // is left out, and the last node has the mean of the strip.
  const Facing2<3>  two(stacked<3>(block<3>("upper", {0., 0., 0.1}, {1., 1., 1.1}, {{1, 1, 1}}),
                                  block<3>("lower", {0.2, -1., -1.}, {0.3, 0.7, 0.}, {{1, 2, 2}})));
  std::vector<bool> excluded;
  for (const Point<3> &position : two.assembled.discretization.node_positions())
    excluded.push_back(std::abs(position[1]) < 1e-6);
  excluded.resize(two.assembled.discretization.matrices().pattern.n_owned);
  const auto nodes = two.pair.at(two.assembled.discretization.make_vector(), 0.2, &excluded);
  EXPECT_EQ(number(nodes), 1u);
  for (const ContactNode<3> &node : nodes)
    {
      EXPECT_NEAR(node.transmission, 0.1 * 0.7 / (0.025 * 0.245), 1e-11);
      EXPECT_NEAR(node.gap * node.distance_per_gap(), 0.1, 1e-13);
    }
}
