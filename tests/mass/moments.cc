// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Each redistribution keeps total mass, centre of gravity and tensor of inertia of a body to
// round-off, on bricks and on curved meshes, with one and with two bodies, and takes all mass away
// from contact nodes. What it gives is positive definite elsewhere.

#include <gtest/gtest.h>

#include "../contact/two_bodies.h"
#include "redistributed.h"

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  void expect_moments(const Redistributed<dim> &problem)
  {
    const std::array<std::string, 3> linear = {{"1", "x", "y"}};
    std::vector<std::string>         functions(linear.begin(), linear.end());
    if (dim == 3)
      functions.push_back("z");
    for (const std::string &left : functions)
      for (const std::string &right : functions)
        {
          std::array<std::string, dim> x, y;
          x.fill(left);
          y.fill(right);
          const auto [redistributed, consistent] = problem.both_products(x, y);
          EXPECT_NEAR(
            redistributed, consistent, 1e-12 * total_mass(problem.discretization) * dim * 4.)
            << left << " " << right;
        }
  }


  template <int dim>
  void expect_massless_contact_nodes(const Redistributed<dim> &problem)
  {
    const auto &matrices = problem.discretization.matrices();
    ASSERT_EQ(matrices.massless_nodes.size(), problem.surface.nodes().size());
    ASSERT_GT(problem.surface.n_global_nodes(), 0u);
    const Vector product =
      mass_times(problem.discretization, irregular_field(problem.discretization, 3.));
    for (const ContactNode<dim> &node : problem.surface.nodes())
      for (unsigned int c = 0; c < dim; ++c)
        EXPECT_EQ(product.local_element(dim * node.node + c), 0.);
    EXPECT_GT(MassSolver<dim>(matrices, {}).smallest_ratio(), 0.02);
  }


  template <int dim>
  void expect_all(const Scene<dim> &scene, const std::string &construction)
  {
    const Redistributed<dim> problem(scene, construction);
    expect_moments(problem);
    expect_massless_contact_nodes(problem);
  }


  /** The minimisation needs finer meshes to stay positive definite. */
  class Construction : public testing::TestWithParam<std::string>
  {
  protected:
    const unsigned int finer = GetParam() == "minimisation" ? 3 : 1;
  };
} // namespace

TEST_P(Construction, KeepsTheMomentsOfBricks)
{
  expect_all(box_on_floor<2>(4 * finer), GetParam());
  expect_all(box_on_floor<2>(2 * finer), GetParam());
  expect_all(box_on_floor<3>(3 * finer), GetParam());
}

TEST_P(Construction, KeepsTheMomentsOfCurvedMeshes)
{
  expect_all(contact_scene<2>(ball<2>(2), {floor_at<2>(0.)}), GetParam());
  expect_all(contact_scene<3>(ball<3>(2), {floor_at<3>(0.)}), GetParam());
  Scene<2> curved = contact_scene<2>(ball<2>(2), {floor_at<2>(0.)});
  curved.mapping  = CellGeometry::curved;
  expect_all(curved, GetParam());
}

TEST_P(Construction, WorksOnTheSlaveOfTwoBodies)
{
  const auto lower = block<2>("lower", {0., -1.}, {2., 0.}, {{3, 2}}),
             upper = block<2>("upper", {0., 0.}, {2., 1.}, {{4, 3 * finer}});
  const Redistributed<2> problem(stacked<2>(upper, lower), GetParam());
  expect_moments(problem);
  expect_massless_contact_nodes(problem);
  // The master is as it was.
  const auto [redistributed, consistent] =
    problem.both_products({{"y < 0", "(y < 0) * x"}}, {{"(y < 0) * x * y", "y < 0"}});
  EXPECT_NEAR(redistributed, consistent, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(All,
                         Construction,
                         testing::Values("extrapolation", "minimisation", "macro-elements"),
                         [](const auto &info) { return info.param.substr(0, 5); });

TEST(Extrapolation, KeepsTheMomentsWhereAllSidesMayTouch)
{
  BodyDescription<3> body  = box<3>();
  box_of(body).repetitions = {{4, 5, 4}};
  expect_all(contact_scene<3>(body, {sphere<3>(dealii::Point<3>(0.5, 0.5, 0.5), 3., true)}),
             "extrapolation");
}

TEST(MassAtHangingNodes, ExtrapolationAndMinimisationKeepTheMoments)
{
  for (const std::string construction : {"extrapolation", "minimisation"})
    {
      BodyDescription<2> body = box_with_hanging_nodes<2>();
      body.refinements        = 2;
      expect_all(contact_scene<2>(body, {floor_at<2>(0.)}, {2}), construction);
    }
  expect_all(contact_scene<3>(box_with_hanging_nodes<3>(), {floor_at<3>(0.)}, {4}),
             "extrapolation");
}
