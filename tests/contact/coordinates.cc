// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Contact coordinates are an orthogonal change of the basis at contact nodes: it can be undone,
// keeps scalar products, makes u.nu a single entry, and is the same on all processes that know a
// node. (Without a second body; for that see relative_coordinates.cc.)

#include "contact_scene.h"

#include <signorini/contact/contact_coordinates.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;
using dealii::Tensor;

namespace
{
  /** A ball in a hollow sphere, where each contact node has another normal. */
  Scene<3> ball_in_hollow_sphere()
  {
    return contact_scene<3>(ball<3>(1), {sphere<3>({0., 0., 1.1}, 1.2, true)});
  }

  /** A box on the floor, with prescribed motions at x = 0 in x, and at y = 1 in y and z. */
  Scene<3> held_box()
  {
    BodyDescription<3> body = box<3>();
    body.dirichlet          = {{0, {{"t + y", "-", "-"}}}, {3, {{"-", "2*t", "0.5"}}}};
    return contact_scene<3>(body, {floor_at<3>(-0.1)}, {4});
  }

  template <int dim>
  struct CoordinatesProblem : public ContactProblem<dim>
  {
    explicit CoordinatesProblem(const Scene<dim> &scene)
      : ContactProblem<dim>(scene)
      , coordinates(this->discretization, this->surface, this->dirichlet)
      , frames(coordinates.node_frames(),
               coordinates.contact_nodes(),
               this->discretization.matrices().pattern.partitioner)
    {
    }
    const ContactCoordinates<dim> coordinates;
    const NodeFrames<dim>         frames;
  };
} // namespace

TEST(ContactCoordinates, CanBeUndoneAndKeepProducts)
{
  const CoordinatesProblem<3> problem(ball_in_hollow_sphere());
  const Vector                x = irregular_field(problem.discretization, 3.),
               y                = irregular_field(problem.discretization, 7.);
  Vector w = x, z = y;
  problem.coordinates.force_to_contact(w);
  problem.coordinates.force_to_contact(z);
  EXPECT_NEAR(w * z, x * y, 1e-13 * x.l2_norm() * y.l2_norm());
  Vector difference = w;
  difference -= x;
  EXPECT_GT(difference.linfty_norm(), 0.1) << "the coordinates are different ones";
  problem.coordinates.displacement_to_cartesian(w);
  w -= x;
  EXPECT_LT(w.linfty_norm(), 1e-14);
}

TEST(ContactCoordinates, NormalDisplacementIsOneEntry)
{
  const CoordinatesProblem<3> problem(ball_in_hollow_sphere());
  const Vector                u   = irregular_field(problem.discretization, 3.);
  const auto                  gap = problem.surface.normal_gap(u);
  Vector                      w   = u;
  problem.coordinates.force_to_contact(w);
  const auto &nodes   = problem.surface.nodes();
  const auto &entries = problem.coordinates.normal_entries();
  ASSERT_EQ(entries.size(), nodes.size());
  for (unsigned int k = 0; k < nodes.size(); ++k)
    EXPECT_NEAR(nodes[k].gap - w.local_element(entries[k]), gap[k], 1e-14);
}

TEST(ContactCoordinates, DirichletConditionsAreSingleEntriesWithTheirValues)
{
  const CoordinatesProblem<3> problem(held_box());
  const double                time    = 0.25;
  const auto                 &entries = problem.coordinates.dirichlet_entries();
  const auto                  values  = problem.coordinates.dirichlet_values(time);
  ASSERT_EQ(values.size(), entries.size());
  // 9 nodes in x, 9 in y and z; the 3 nodes at y = 1 on the floor take no part in contact.
  EXPECT_EQ(dealii::Utilities::MPI::sum(entries.size(), MPI_COMM_WORLD), 27u);
  EXPECT_EQ(problem.surface.n_global_nodes(), 6u);

  // A displacement with the prescribed values has them in these entries, up to the sign of the
  // direction.
  Vector w = field<3>(problem.discretization, {{"0.25 + y", "0.5", "0.5"}});
  problem.coordinates.force_to_contact(w);
  for (unsigned int k = 0; k < entries.size(); ++k)
    EXPECT_NEAR(w.local_element(entries[k]), values[k], 1e-14);
}

// Prescribed tangents of a contact node are rows of its frame, along the axis or against it; the
// values follow. On a floor one of two must be against, as the normal points downwards.
TEST(ContactCoordinates, DirichletConditionsInBothTangents)
{
  BodyDescription<3> body = box<3>();
  body.dirichlet          = {{4, {{"0.1*t", "0.2*t + x", "-"}}}};
  const CoordinatesProblem<3> problem(contact_scene<3>(body, {floor_at<3>(-0.1)}, {4}));
  EXPECT_EQ(problem.surface.n_global_nodes(), 9u);
  const auto &entries = problem.coordinates.dirichlet_entries();
  EXPECT_EQ(dealii::Utilities::MPI::sum(entries.size(), MPI_COMM_WORLD), 18u);

  Vector     w      = problem.discretization.make_vector();
  const auto values = problem.coordinates.dirichlet_values(2.);
  for (unsigned int k = 0; k < entries.size(); ++k)
    w.local_element(entries[k]) = values[k];
  problem.coordinates.displacement_to_cartesian(w);
  for (const ContactNode<3> &node : problem.surface.nodes())
    {
      EXPECT_NEAR(w.local_element(3 * node.node), 0.2, 1e-15);
      EXPECT_NEAR(w.local_element(3 * node.node + 1), 0.4 + node.position[0], 1e-15);
    }
}

// A process knows for its ghosts, too, which directions are held: the same as their owner.
TEST(ContactCoordinates, HeldNodesAreKnownWithTheirGhosts)
{
  const CoordinatesProblem<3> problem(ball_in_hollow_sphere());
  const auto                 &pattern = problem.discretization.matrices().pattern;
  const dealii::Point<3>      centre(0., 0., 1.);
  const auto                  is_held = [](const dealii::Point<3> &p) { return p[0] > 0.3; };

  Mask mask(3 * pattern.n_owned, 0);
  for (const ContactNode<3> &node : problem.surface.nodes())
    if (is_held(node.position))
      mask[3 * node.node] = 1;
  const HeldNodes<3> held = problem.frames.held_nodes(mask);

  std::vector<unsigned int> expected, found;
  for (unsigned int node = 0; node < pattern.n_local; ++node)
    {
      const dealii::Point<3> &p = problem.discretization.node_positions()[node];
      if (p.distance(centre) > 1. - 1e-10 && is_held(p))
        expected.push_back(node);
    }
  for (const HeldNode<3> &node : held)
    {
      found.push_back(node.node);
      EXPECT_TRUE(node.held[0] && !node.held[1] && !node.held[2]);
      const auto normal = problem.scene.obstacles[0]
                            .shape->project(problem.discretization.node_positions()[node.node])
                            .normal;
      EXPECT_LT((Tensor<1, 3>({node.frame[0], node.frame[1], node.frame[2]}) - normal).norm(),
                1e-14);
    }
  EXPECT_EQ(found, expected);
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    {
      const unsigned int n_ghosts =
        std::count_if(found.begin(), found.end(), [&](const unsigned int node) {
          return node >= pattern.n_owned;
        });
      EXPECT_GT(dealii::Utilities::MPI::sum(n_ghosts, MPI_COMM_WORLD), 0u);
    }
}

TEST(ContactCoordinates, SpecialNodesAreContactNodesAndDirichletConditions)
{
  const CoordinatesProblem<3> problem(held_box());
  std::vector<unsigned int>   special, contact;
  for (unsigned int node = 0; node < problem.discretization.matrices().pattern.n_local; ++node)
    {
      const dealii::Point<3> &p          = problem.discretization.node_positions()[node];
      const bool              at_contact = p[2] == 0. && p[1] < 1.;
      if (p[0] == 0. || p[1] == 1. || at_contact)
        special.push_back(node);
      if (at_contact)
        contact.push_back(node);
    }
  EXPECT_EQ(problem.frames.special_nodes(), special);
  EXPECT_EQ(problem.frames.contact_nodes(), contact);
}
