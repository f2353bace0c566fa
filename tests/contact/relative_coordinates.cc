// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// With two bodies in contact the change of coordinates T is not orthogonal, but it is invertible,
// forces transform by its transpose, the normal entry is the relative displacement, and a contact
// force alone is equal and opposite on the two bodies. Where friction acts all this holds for the
// tangential entries, too, and without friction these are the node's own.

#include "two_bodies.h"

#include <signorini/obstacles/plane.h>
#include <signorini/preconditioners/step_operator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /**
   * Blocks off-centre with hanging nodes on both sides and nodes without multiplier; the master
   * also stands on a floor.
   */
  Scene<3> scene_3d()
  {
    auto slave              = block<3>("slave", {0., 0., 0.}, {1., 1., 1.}, {{2, 3, 1}});
    auto master             = block<3>("master", {0.45, -0.3, -1.}, {1.7, 0.8, -0.05}, {{3, 2, 2}});
    slave.local_refinements = master.local_refinements = 1;
    slave.refine_where = master.refine_where = "x - 0.4 + y";
    slave.dirichlet                          = {{2, {{"-", "-", "0"}}}, {1, {{"-", "0", "-"}}}};
    Scene<3> scene                           = stacked<3>(slave, master);
    scene.obstacles.push_back(
      {"floor", std::make_shared<Plane<3>>(Point<3>(0., 0., -1.1), Tensor<1, 3>({0., 0., 1.}))});
    PairDescription pair;
    pair.name               = "master : floor";
    pair.slave              = 1;
    pair.slave_boundary_ids = {4};
    pair.obstacle           = 0;
    scene.pairs.push_back(pair);
    return scene;
  }

  Scene<2> scene_2d()
  {
    return stacked<2>(block<2>("slave", {0., 0.}, {1., 1.}, {{4, 3}}),
                      block<2>("master", {0.3, -1.}, {std::sqrt(2.), -0.1}, {{7, 2}}));
  }

  template <int dim>
  Tensor<1, dim> at_node(const Vector &u, const unsigned int node)
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = u.local_element(dim * node + c);
    return result;
  }

  template <int dim>
  void expect_inverse_and_transpose(const TwoBodies<dim> &bodies)
  {
    const auto  &coordinates = bodies.coordinates;
    const Vector u           = irregular_field(bodies.discretization, 3.),
                 f           = irregular_field(bodies.discretization, 7.);

    Vector w = u;
    coordinates.displacement_to_contact(w);
    Vector back = w;
    coordinates.displacement_to_cartesian(back);
    back -= u;
    EXPECT_LT(back.linfty_norm(), 1e-13 * u.linfty_norm());
    back = u;
    coordinates.displacement_to_cartesian(back);
    coordinates.displacement_to_contact(back);
    back -= u;
    EXPECT_LT(back.linfty_norm(), 1e-13 * u.linfty_norm());

    Vector force = f;
    coordinates.force_to_contact(force);
    EXPECT_NEAR(force * w, f * u, 1e-13 * f.l2_norm() * u.l2_norm())
      << "work does not depend on the coordinates";
    EXPECT_GT(std::abs(f * w - f * u), 1e-3) << "but the entries do";
    coordinates.force_to_cartesian(force);
    force -= f;
    EXPECT_LT(force.linfty_norm(), 1e-13 * f.linfty_norm());
  }

  template <int dim>
  void expect_relative_entries(const TwoBodies<dim> &bodies)
  {
    const Vector u        = irregular_field(bodies.discretization, 3.);
    Vector       w        = u;
    const auto   relative = bodies.surface.relative_normal(u);
    const auto   sliding  = bodies.surface.relative_tangential(u);
    const auto   gap      = bodies.surface.normal_gap(u);
    bodies.coordinates.displacement_to_contact(w);
    const auto &entries = bodies.coordinates.normal_entries();
    const auto &nodes   = bodies.surface.nodes();
    ASSERT_EQ(entries.size(), relative.size());
    for (unsigned int k = 0; k < entries.size(); ++k)
      {
        EXPECT_NEAR(w.local_element(entries[k]), relative[k], 1e-14);
        EXPECT_NEAR(nodes[k].gap - relative[k], gap[k], 1e-14);
        EXPECT_NEAR(sliding[k] * nodes[k].normal(), 0., 1e-14);
        for (unsigned int row = 1; row < dim; ++row)
          EXPECT_NEAR(w.local_element(entries[k] + row),
                      nodes[k].direction(row)
                        * (nodes[k].relative[row] ? sliding[k] : at_node<dim>(u, nodes[k].node)),
                      1e-14);
      }
  }

  /**
   * All directions in which friction can act are relative, if there is another body; the normal
   * always is.
   */
  template <int dim>
  void expect_right_directions(const TwoBodies<dim> &bodies)
  {
    const auto               &nodes = bodies.surface.nodes();
    std::vector<unsigned int> relative;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const bool                has_partners = !nodes[k].partners.empty();
        std::vector<unsigned int> tangential;
        EXPECT_EQ(nodes[k].friction.any(), bodies.scene.pairs[nodes[k].pair].friction.any);
        EXPECT_EQ(nodes[k].relative[0], has_partners);
        const auto &prescribed = bodies.coordinates.dirichlet_entries();
        for (unsigned int row = 0; row < dim; ++row)
          {
            const unsigned int entry = dim * nodes[k].node + row;
            const bool         is_held =
              std::find(prescribed.begin(), prescribed.end(), entry) != prescribed.end();
            const bool acts = row > 0 && nodes[k].friction.any() && !is_held;
            if (acts)
              tangential.push_back(entry);
            if (has_partners && (row == 0 || acts))
              relative.push_back(entry);
          }
        EXPECT_EQ(bodies.coordinates.tangential_entries()[k], tangential);
      }
    EXPECT_EQ(bodies.coordinates.relative_entries(), relative);
  }

  /**
   * What both bodies do is not relative; what the slave does alone is, and a node that takes the
   * share of another sees more of it.
   */
  template <int dim>
  void expect_translations(const TwoBodies<dim> &bodies)
  {
    Tensor<1, dim> shift;
    for (unsigned int c = 0; c < dim; ++c)
      shift[c] = 1. - 0.7 * c;
    Vector both = bodies.nodal([&](const Point<dim> &) { return shift; }), slave = both;
    for (const Tensor<1, dim> &sliding : bodies.surface.relative_tangential(both))
      if (bodies.scene.pairs.size() == 1)
        {
          EXPECT_LT(sliding.norm(), 1e-13);
        }
    bodies.coordinates.displacement_to_contact(both);
    for (const unsigned int i : bodies.coordinates.relative_entries())
      EXPECT_NEAR(both.local_element(i), 0., 1e-13);

    const auto is_slave = bodies.nodes_of_body(0);
    for (unsigned int node = 0; node < is_slave.size(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        if (!is_slave[node])
          slave.local_element(dim * node + c) = 0.;
    const auto sliding = bodies.surface.relative_tangential(slave);
    bodies.coordinates.displacement_to_contact(slave);
    for (std::size_t k = 0; k < sliding.size(); ++k)
      if (const ContactNode<dim> &node = bodies.surface.nodes()[k]; node.pair == 0)
        {
          const Tensor<1, dim> tangential = shift - (shift * node.normal()) * node.normal();
          EXPECT_LT((sliding[k] - node.transmission * tangential).norm(), 1e-12);
          for (unsigned int row = 0; row < dim; ++row)
            EXPECT_NEAR(slave.local_element(dim * node.node + row),
                        (node.relative[row] ? node.transmission : 1.)
                          * (shift * node.direction(row)),
                        1e-12);
        }
  }

  /** Forces on all relative entries that a direction of the frame has. */
  template <int dim>
  void expect_equal_and_opposite_forces(const TwoBodies<dim> &bodies, const unsigned int row)
  {
    Vector         force = bodies.discretization.make_vector();
    Tensor<1, dim> on_slave;
    double         scale = 0.;
    for (const ContactNode<dim> &node : bodies.surface.nodes())
      if (node.pair == 0 && node.relative[row])
        {
          const double value = -1. - std::sin(20. * node.position[0] + 7. * node.position[dim - 1]);
          force.local_element(dim * node.node + row) = value;
          on_slave += node.transmission * value * node.direction(row);
          scale += std::abs(value);
        }
    on_slave = dealii::Utilities::MPI::sum(on_slave, MPI_COMM_WORLD);
    scale    = dealii::Utilities::MPI::sum(scale, MPI_COMM_WORLD);
    bodies.coordinates.force_to_cartesian(force);
    EXPECT_LT((bodies.resultant_on(0, force) - on_slave).norm(), 1e-13 * scale)
      << "the transmission says so";
    EXPECT_LT((bodies.resultant_on(1, force) + on_slave).norm(), 1e-13 * scale);
    EXPECT_GT(on_slave.norm(), 0.5 * scale);
  }

  /** T'(M + s A)T is symmetric, and gives the energy of the Cartesian displacement. */
  template <int dim>
  void expect_energy(const TwoBodies<dim> &bodies)
  {
    const auto             &discretization = bodies.discretization;
    const StepOperator<dim> matrix(discretization.matrices(), bodies.coordinates, {2., 0.3});
    const Vector u = irregular_field(discretization, 3.), v = irregular_field(discretization, 7.);
    Vector       w = u, z = v, product = u;
    bodies.coordinates.displacement_to_contact(w);
    bodies.coordinates.displacement_to_contact(z);
    matrix.vmult(product, w);
    const double expected =
      v * mass_times(discretization, u) * 2. + v * stiffness_times(discretization, u) * 0.3;
    const double scale = product.l2_norm() * z.l2_norm();
    EXPECT_NEAR(z * product, expected, 1e-13 * scale);
    matrix.vmult(product, z);
    EXPECT_NEAR(w * product, expected, 1e-13 * scale);
  }

  template <int dim>
  void expect_all(Scene<dim> scene, const double angle)
  {
    for (const bool friction : {false, true})
      {
        SCOPED_TRACE(friction ? "with friction" : "without friction");
        scene.pairs[0].friction = {FrictionKind::coulomb, "0.3", "", friction};
        const TwoBodies<dim> bodies(scene, angle == 0. ? Map<dim>() : turn<dim>(angle));
        expect_inverse_and_transpose(bodies);
        expect_right_directions(bodies);
        expect_relative_entries(bodies);
        expect_translations(bodies);
        for (unsigned int row = 0; row < (friction ? dim : 1); ++row)
          expect_equal_and_opposite_forces(bodies, row);
        expect_energy(bodies);
      }
  }
} // namespace

TEST(RelativeCoordinates, In2d)
{
  for (const double angle : {0., 0.7})
    expect_all(scene_2d(), angle);
}

// The normal of some slave nodes is prescribed, and one of the tangents of others.
TEST(RelativeCoordinates, In3d)
{
  expect_all(scene_3d(), 0.);
}

// The scene above has what it is there for, so that the expectations are not empty.
TEST(RelativeCoordinates, SomeTangentsAreHeldIn3d)
{
  Scene<3> scene          = scene_3d();
  scene.pairs[0].friction = {FrictionKind::coulomb, "0.3", "", true};
  const TwoBodies<3> bodies(scene);
  const auto         count = [&](const unsigned int n) {
    return bodies.sum(
      [n](const ContactNode<3> &node) { return 0u + node.relative[1] + node.relative[2] == n; });
  };
  EXPECT_EQ(count(1), bodies.sum([](const ContactNode<3> &node) {
    return node.pair == 0 && node.position[0] == 1.;
  }));
  EXPECT_GT(count(1), 1.);
  EXPECT_GT(count(2), 1.);
  EXPECT_EQ(count(0), bodies.sum([](const ContactNode<3> &node) { return node.pair == 1; }));
}

// The same in a general position, without prescribed nodes.
TEST(RelativeCoordinates, In3dTurned)
{
  Scene<3> scene            = scene_3d();
  scene.bodies[0].dirichlet = {};
  scene.pairs.resize(1);
  expect_all(scene, 0.7);
}

// Normals that differ from node to node, and a curved master.
TEST(RelativeCoordinates, OfTwoBalls)
{
  auto upper = ball<3>(1), lower = ball<3>(2);
  upper.name            = "upper";
  lower.name            = "lower";
  ball_of(lower).centre = Point<3>(0.2, -0.1, -1.2);
  Scene<3>        scene = scene_of<3>({upper, lower});
  PairDescription pair;
  pair.name   = "upper : lower";
  pair.slave  = 0;
  pair.master = 1;
  scene.pairs.push_back(pair);
  expect_all(scene, 0.);
}
