// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The mortar coupling of non-matching surfaces: weights share out the covered area, relative
// displacements vanish for rigid motions of both bodies, and where the surfaces are flat also for
// every linear field, whose gap is then exact. Hanging nodes, Dirichlet conditions and partial
// cover change none of this, and neither does the orientation in space. Relative displacement and
// gap of a node that takes the share of a node without multiplier are larger by the same factor,
// its transmission.

#include "two_bodies.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const double root = std::sqrt(2.), pi = dealii::numbers::PI;

  template <int dim>
  struct Case
  {
    std::string name;
    Scene<dim>  scene;
    double      covered;   ///< area
    double      gap;       ///< distance of the flat surfaces
    bool        all_carry; ///< all nodes with a share of the covered area carry a multiplier
  };

  BodyDescription<3>
  with_hanging_nodes(BodyDescription<3> body, const std::string &where, const unsigned int levels)
  {
    body.local_refinements = levels;
    body.refine_where      = where;
    return body;
  }

  std::vector<Case<3>> cases_3d()
  {
    const auto slave = block<3>("slave", {0., 0., 0.}, {1., 1., 1.}, {{2, 3, 1}});
    const auto same  = block<3>("same", {0., 0., -1.}, {1., 1., 0.}, {{6, 9, 1}}), // 1 to 3
      odd = block<3>("odd", {-root / 3., -pi / 7., -1.}, {root, pi / 2., -0.25}, {{3, 4, 1}}),
               small  = block<3>("small", {0.07, root / 9., -1.}, {pi / 4., 0.8, 0.}, {{2, 2, 1}}),
               corner = block<3>("corner", {0.45, 0.45, -1.}, {3., 2., -0.1}, {{2, 3, 1}});
    const auto coarse = block<3>("coarse", {0., 0., -1.}, {1., 1., 0.}, {{1, 2, 1}});
    const auto fine   = with_hanging_nodes(slave, "0.6 - x*y - z", 2);
    const auto graded = with_hanging_nodes(odd, "x + y - 0.8 + z", 2);
    return {
      {"1 to 3", stacked<3>(slave, same), 1., 0., true},
      {"3 to 1",
       stacked<3>(block<3>("slave", {0., 0., 0.}, {1., 1., 1.}, {{6, 9, 1}}), coarse),
       1.,
       0.,
       true},
      {"irrational", stacked<3>(slave, odd), 1., 0.25, true},
      {"small master", stacked<3>(slave, small), (pi / 4. - 0.07) * (0.8 - root / 9.), 0., true},
      {"corner", stacked<3>(slave, corner), 0.55 * 0.55, 0.1, false},
      {"hanging on the slave", stacked<3>(fine, same), 1., 0., true},
      {"hanging on the master", stacked<3>(slave, graded), 1., 0.25, true},
      {"hanging on both", stacked<3>(fine, graded), 1., 0.25, true},
      {"hanging and a corner", stacked<3>(fine, corner), 0.55 * 0.55, 0.1, false}};
  }

  std::vector<Case<2>> cases_2d()
  {
    const auto slave = block<2>("slave", {0., 0.}, {1., 1.}, {{2, 1}});
    return {
      {"1 to 3", stacked<2>(slave, block<2>("same", {0., -1.}, {1., 0.}, {{6, 1}})), 1., 0., true},
      {"irrational",
       stacked<2>(slave, block<2>("odd", {-root / 3., -1.}, {root, -0.25}, {{5, 1}})),
       1.,
       0.25,
       true},
      {"part",
       stacked<2>(slave, block<2>("part", {root / 2., -1.}, {root, -0.25}, {{5, 1}})),
       1. - root / 2.,
       0.25,
       true},
      {"sliver",
       stacked<2>(slave, block<2>("sliver", {0.3, -1.}, {0.51, -0.25}, {{5, 1}})),
       0.21,
       0.25,
       false}};
  }

  template <int dim>
  void expect_row_sums_of_one(const TwoBodies<dim> &bodies, const std::string &name)
  {
    EXPECT_GT(bodies.surface.n_global_nodes(), 0u) << name;
    for (const ContactNode<dim> &node : bodies.surface.nodes())
      {
        double row_sum = 0.;
        for (const auto &[partner, weight] : node.partners)
          row_sum += weight;
        EXPECT_NEAR(row_sum, 1., 1e-12) << name << " at " << node.position;
      }
  }

  /** Of surfaces in planes across the normal (pointing out of the slave). */
  template <int dim>
  void expect_linear_functions(const TwoBodies<dim> &bodies,
                               const Tensor<2, dim> &turned,
                               const std::string    &name)
  {
    const auto axis = [&](const unsigned int d) {
      return turned * Tensor<1, dim>(Point<dim>::unit_vector(d));
    };
    const Tensor<1, dim> normal = -axis(dim - 1);
    for (const ContactNode<dim> &node : bodies.surface.nodes())
      EXPECT_LT((node.normal() - normal).norm(), 1e-13) << name << " at " << node.position;
    for (unsigned int d = 0; d < dim - 1; ++d)
      for (const double relative : bodies.surface.relative_normal(
             bodies.nodal([&](const Point<dim> &p) { return (axis(d) * p) * normal; })))
        EXPECT_NEAR(relative, 0., 1e-12) << name << ", function " << d;
    const auto relative = bodies.surface.relative_normal(
      bodies.nodal([&](const Point<dim> &p) { return (normal * p) * normal; }));
    for (unsigned int k = 0; k < relative.size(); ++k)
      EXPECT_NEAR(relative[k], -bodies.surface.nodes()[k].gap, 1e-12) << name << ": g = -nu.[X]";
  }

  template <int dim>
  void expect_consistent(const Case<dim> &c, const double angle)
  {
    const TwoBodies<dim> bodies(c.scene, turn<dim>(angle));
    const std::string    name = c.name + " at " + std::to_string(angle);
    const auto weights     = bodies.sum([](const ContactNode<dim> &node) { return node.weight; }),
               transmitted = bodies.sum(
                 [](const ContactNode<dim> &node) { return node.weight * node.transmission; });
    for (const ContactNode<dim> &node : bodies.surface.nodes())
      {
        EXPECT_GT(node.weight, 0.) << name;
        EXPECT_NEAR(node.gap, c.gap * node.transmission, 1e-12) << name << " at " << node.position;
        EXPECT_GT(node.transmission, c.all_carry ? 1. - 1e-12 : 0.9) << name;
        EXPECT_LT(node.transmission, c.all_carry ? 1. + 1e-12 : 2.) << name;
      }
    EXPECT_NEAR(bodies.mortar.covered_area(), c.covered, 1e-13) << name;
    EXPECT_NEAR(transmitted, c.covered, 1e-12) << name;
    if (c.all_carry)
      EXPECT_NEAR(weights, c.covered, 1e-12) << name;
    else
      EXPECT_LT(weights, 0.9999 * c.covered) << name;
    expect_row_sums_of_one(bodies, name);
    expect_linear_functions(bodies, rotation<dim>(angle), name);
  }

  /** Blocks with matching footprints, the slave prescribed at x = 0. */
  TwoBodies<3> prescribed(const std::array<std::string, 3> &slave_condition,
                          const bool                        of_master = false)
  {
    auto slave  = block<3>("slave", {0., 0., 0.}, {1., 1., 1.}, {{3, 2, 1}}),
         master = block<3>("master", {0., 0., -1.}, {1., 1., -0.125}, {{5, 3, 1}});
    (of_master ? master : slave).dirichlet = {{0, slave_condition}};
    return TwoBodies<3>(stacked<3>(slave, master));
  }
} // namespace

TEST(MortarCoupling, FlatSurfacesIn2d)
{
  for (const auto &c : cases_2d())
    for (const double angle : {0., 0.7, 2.})
      expect_consistent(c, angle);
}

TEST(MortarCoupling, FlatSurfacesIn3d)
{
  for (const auto &c : cases_3d())
    for (const double angle : {0., 0.7})
      expect_consistent(c, angle);
}

// The cases above say what they claim: there are hanging nodes on both surfaces, and none of them
// carries a multiplier.
TEST(MortarCoupling, HangingNodesCarryNothing)
{
  for (const auto &c : cases_3d())
    if (c.name == "hanging on both")
      {
        const TwoBodies<3>          bodies(c.scene);
        const auto                 &discretization = bodies.discretization;
        std::array<unsigned int, 2> n_hanging{};
        for (unsigned int body = 0; body < 2; ++body)
          {
            const auto of_body = bodies.nodes_of_body(body);
            for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
              if (of_body[node] && discretization.matrices().pattern.is_empty(node)
                  && discretization.node_positions()[node][2] == (body == 0 ? 0. : -0.25))
                ++n_hanging[body];
            EXPECT_GT(dealii::Utilities::MPI::sum(n_hanging[body], MPI_COMM_WORLD), 0u) << body;
          }
        std::vector<double> marks;
        Vector              mark = discretization.make_vector();
        for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
          if (discretization.matrices().pattern.is_empty(node))
            mark.local_element(3 * node + 2) = 1.;
        for (const double relative : bodies.surface.relative_normal(mark))
          EXPECT_EQ(relative, 0.) << "hanging nodes are replaced by their parents";
      }
}

// An inclined flat master: the gap is the distance along the slave normal at the node, of which the
// part along the normal of contact counts, which halves the angle between both surfaces.
TEST(MortarCoupling, GapOfAnInclinedMaster)
{
  for (const auto &c : cases_3d())
    {
      // Not where slave and master share a plane, because the map would move both, nor where nodes
      // carry no multiplier, because the gaps of their neighbours are weighted means then.
      if (c.gap == 0. || !c.all_carry)
        continue;
      const TwoBodies<3> bodies(c.scene, [](const Point<3> &p) {
        return p[2] < 0. ? Point<3>(p[0], p[1], p[2] - 0.2 - 0.1 * p[0] + 0.05 * p[1]) : p;
      });
      expect_row_sums_of_one(bodies, c.name);
      const double half_angle = 0.5 * std::acos(1. / std::sqrt(1. + 0.1 * 0.1 + 0.05 * 0.05));
      for (const ContactNode<3> &node : bodies.surface.nodes())
        EXPECT_NEAR(node.gap,
                    (c.gap + 0.2 + 0.1 * node.position[0] - 0.05 * node.position[1])
                      * std::cos(half_angle),
                    1e-12)
          << c.name;
    }
}

TEST(MortarCoupling, CurvedSurfacesReproduceConstants)
{
  for (const auto &c : cases_3d())
    {
      if (c.gap == 0.)
        continue; // facets of curved surfaces that touch overlap
      const TwoBodies<3> bodies(c.scene, [](const Point<3> &p) {
        return Point<3>(p[0],
                        p[1],
                        p[2] + 0.1 * std::sin(3. * p[0]) + 0.2 * p[1] * p[1]
                          + (p[2] < 0. ? -0.1 : 0.));
      });
      expect_row_sums_of_one(bodies, c.name);
      for (const ContactNode<3> &node : bodies.surface.nodes())
        EXPECT_GT(node.weight, 0.) << c.name;
    }
}

TEST(MortarCoupling, NormalConditionTakesTheMultiplier)
{
  const TwoBodies<3> bodies = prescribed({{"-", "-", "0"}});
  EXPECT_EQ(bodies.surface.n_left_to_dirichlet_conditions(), 3u);
  EXPECT_EQ(bodies.surface.n_global_nodes(), 9u);
  for (const ContactNode<3> &node : bodies.surface.nodes())
    {
      EXPECT_GT(node.position[0], 0.);
      EXPECT_NEAR(node.gap, 0.125 * node.transmission, 1e-13);
      EXPECT_NEAR(node.transmission, node.position[0] < 0.34 ? 1.5 : 1., 1e-12)
        << "takes the share of its neighbour";
    }
  EXPECT_NEAR(bodies.sum([](const ContactNode<3> &node) { return node.weight; }), 5. / 6., 1e-13);
  EXPECT_NEAR(
    bodies.sum([](const ContactNode<3> &node) { return node.weight * node.transmission; }),
    1.,
    1e-12);
  expect_row_sums_of_one(bodies, "prescribed");
  expect_linear_functions(bodies, rotation<3>(0.), "prescribed");
}

TEST(MortarCoupling, OtherDirichletConditionsLeaveTheMultiplier)
{
  const auto expect_untouched = [](const TwoBodies<3> &bodies) {
    EXPECT_EQ(bodies.surface.n_left_to_dirichlet_conditions(), 0u);
    EXPECT_EQ(bodies.surface.n_global_nodes(), 12u);
    EXPECT_NEAR(bodies.sum([](const ContactNode<3> &node) { return node.weight; }), 1., 1e-13);
    expect_row_sums_of_one(bodies, "prescribed");
    expect_linear_functions(bodies, rotation<3>(0.), "prescribed");
  };
  expect_untouched(prescribed({{"0", "0", "-"}}));
  expect_untouched(prescribed({{"0", "0", "0"}}, true));
}

// Both processes see the same: a checksum over all contact nodes.
TEST(MortarCoupling, DoesNotDependOnTheNumberOfProcesses)
{
  for (const auto &c : cases_3d())
    if (c.name == "hanging on both")
      {
        const TwoBodies<3> bodies(c.scene);
        EXPECT_EQ(bodies.surface.n_global_nodes(), 38u);
        EXPECT_NEAR(bodies.sum([](const ContactNode<3> &node) {
          double squares = 0.;
          for (const auto &[partner, weight] : node.partners)
            squares += weight * weight;
          return squares * (1. + node.position[0] + 0.3 * node.position[1]);
        }),
                    33.365740463888415,
                    1e-11);
      }
}
