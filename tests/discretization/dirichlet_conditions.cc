// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A Dirichlet condition prescribes exactly the given components of the nodes of its boundary,
// hanging nodes excepted (they follow their neighbours), with the values of its expression in space
// and time. Where two meet, the first one in the scene counts.

#include "bodies.h"

#include <signorini/base/user_error.h>
#include <signorini/discretization/dirichlet_conditions.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr unsigned int none = DirichletConditions<2>::none;

  template <int dim>
  unsigned int n_global(const DirichletConditions<dim> &dirichlet)
  {
    return dealii::Utilities::MPI::sum(static_cast<unsigned int>(dirichlet.nodes().size()),
                                       MPI_COMM_WORLD);
  }
} // namespace

TEST(DirichletConditions, PrescribeTheGivenComponents)
{
  BodyDescription<2> body = box<2>();
  body.dirichlet          = {{0, {{"0", "-"}}}, {2, {{"1", "x*t"}}}};
  const Assembled<2>           assembled(body);
  const DirichletConditions<2> dirichlet(assembled.discretization);

  EXPECT_EQ(n_global(dirichlet), 5u);
  for (const auto &[node, components] : dirichlet.nodes())
    {
      const auto &p = assembled.discretization.node_positions()[node];
      EXPECT_TRUE(p[0] == 0. || p[1] == 0.) << p;
      EXPECT_EQ(components[0], p[0] == 0. ? 0u : 1u) << p;
      EXPECT_EQ(components[1], p[1] == 0. ? 1u : none) << p;
    }
  EXPECT_EQ(dirichlet.value(0, {0., 0.5}, 0, 7.), 0.);
  EXPECT_EQ(dirichlet.value(1, {0.5, 0.}, 0, 7.), 1.);
  EXPECT_DOUBLE_EQ(dirichlet.value(1, {0.5, 0.}, 1, 7.), 3.5);
  EXPECT_DOUBLE_EQ(dirichlet.value(1, {0.5, 0.}, 1, 2.), 1.);
}

// Where boundaries meet, two conditions may prescribe the same component: they must agree at all
// times of the run.
TEST(DirichletConditions, MustAgreeWhereTheyMeet)
{
  const auto check = [](const std::string &left, const std::string &bottom) {
    BodyDescription<2> body = box<2>();
    body.dirichlet          = {{0, {{left, "-"}}}, {2, {{bottom, "0"}}}};
    const Assembled<2> assembled(body);
    return DirichletConditions<2>(assembled.discretization).check_shared_nodes(3.);
  };
  EXPECT_TRUE(check("-", "0").empty());
  EXPECT_EQ(check("0", "0").size(), 1u);
  EXPECT_EQ(check("y*t", "x*t").size(), 1u) << "zero where they meet";
  for (const auto &[left, bottom] :
       {std::pair<std::string, std::string>{"1", "0"}, {"0", "t"}, {"sin(4*pi/3*t)", "0"}})
    try
      {
        check(left, bottom);
        ADD_FAILURE() << left << " and " << bottom;
      }
    catch (const UserError &error)
      {
        for (const char *const part : {"Dirichlet", "boundaries 0 and 2", "(0 0)", "in x"})
          EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      }
}

TEST(DirichletConditions, LeaveOutHangingNodesAndOtherBodies)
{
  BodyDescription<3> fine = box_with_hanging_nodes<3>(), other = box<3>();
  fine.dirichlet             = {{4, {{"0", "0", "0"}}}};
  box_of(other).lower_corner = dealii::Point<3>(2., 0., 0.);
  box_of(other).upper_corner = dealii::Point<3>(3., 1., 1.);
  const Assembled<3>           assembled(scene_of<3>({other, fine}));
  const auto                  &discretization = assembled.discretization;
  const DirichletConditions<3> dirichlet(discretization);

  // The mesh of the face z = 0 repeats that of a square with the same refinement.
  const Assembled<2> face(box_with_hanging_nodes<2>());
  const auto        &owned     = face.discretization.locally_owned();
  const double       n_hanging = sum_over_nodes(face.discretization, [&](const unsigned int node) {
    return face.discretization.hanging_node_constraints().is_constrained(
             owned.nth_index_in_set(2 * node))
                   ? 1.
                   : 0.;
  });
  EXPECT_GT(n_hanging, 0.);
  EXPECT_EQ(n_global(dirichlet), face.discretization.dof_handler().n_dofs() / 2 - n_hanging);
  for (const auto &[node, components] : dirichlet.nodes())
    {
      EXPECT_EQ(discretization.node_positions()[node][2], 0.);
      EXPECT_LE(discretization.node_positions()[node][0], 1.);
      EXPECT_FALSE(discretization.hanging_node_constraints().is_constrained(
        discretization.locally_owned().nth_index_in_set(3 * node)));
    }
}
