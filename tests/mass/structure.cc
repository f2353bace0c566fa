// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What the redistributions look like where it is known: on two layers of equal bricks extrapolation
// and macro-elements both give the block rho h (8/3, -2/3; -2/3, 2/3) across the layers; zero
// boundary mass only deletes; and what cannot be done is refused.

#include <signorini/base/user_error.h>

#include <gtest/gtest.h>

#include "redistributed.h"

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  std::string refusal(const Scene<dim> &scene, const std::string &construction)
  {
    try
      {
        const Redistributed<dim> problem(scene, construction);
      }
    catch (const UserError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(MassStructure, BlockOfTwoLayers)
{
  // Columns move alike, so that only the direction across the layers is left: h = 1/2, width 2,
  // density 2.
  const double unit = 2. * 2. * 0.5;
  for (const std::string construction : {"extrapolation", "macro-elements"})
    {
      const Redistributed<2> problem(box_on_floor<2>(2), construction);
      const auto             product = [&](const std::string &left, const std::string &right) {
        return problem.both_products({{left, "0"}}, {{right, "0"}}).first / unit;
      };
      const std::string first = "abs(y - 0.5) < 0.1", second = "y > 0.9";
      EXPECT_NEAR(product(first, first), 8. / 3., 1e-12) << construction;
      EXPECT_NEAR(product(first, second), -2. / 3., 1e-12) << construction;
      EXPECT_NEAR(product(second, second), 2. / 3., 1e-12) << construction;
    }
}

TEST(MassStructure, MacroElementsAreExtrapolationOnBricks)
{
  const Redistributed<3> a(box_on_floor<3>(3), "extrapolation"),
    b(box_on_floor<3>(3), "macro-elements");
  const Vector x          = irregular_field(a.discretization, 3.);
  Vector       difference = mass_times(a.discretization, x);
  difference -= mass_times(b.discretization, x);
  EXPECT_LT(difference.linfty_norm(), 1e-14);
}

TEST(MassStructure, ZeroOnTheContactBoundaryDeletes)
{
  const Redistributed<2> problem(box_on_floor<2>(4), "zero");
  const auto [x, y] = std::pair<std::string, std::string>("(y > 0.1) * sin(3*x + y)", "y > 0.1");
  const auto [without, consistent]       = problem.both_products({{x, y}}, {{y, x}});
  const auto [of_boundary, consistent_b] = problem.both_products({{"y < 0.1", "0"}}, {{"1", "x"}});
  EXPECT_NEAR(without, consistent, 1e-14);
  EXPECT_EQ(of_boundary, 0.);
  EXPECT_GT(consistent_b, 0.1);
}

TEST(MassStructure, SolutionsAreInverse)
{
  const Redistributed<3> problem(contact_scene<3>(ball<3>(2), {floor_at<3>(0.)}), "extrapolation");
  const auto            &matrices = problem.discretization.matrices();
  Vector                 x        = irregular_field(problem.discretization, 3.);
  for (const unsigned int node : matrices.massless_nodes)
    for (unsigned int c = 0; c < 3; ++c)
      x.local_element(3 * node + c) = 0.;
  Vector found = MassSolver<3>(matrices, {}).solve(mass_times(problem.discretization, x));
  found -= x;
  EXPECT_LT(found.linfty_norm(), 1e-12 * x.linfty_norm());
}

TEST(MassStructure, AnIndefiniteMassIsFound)
{
  Redistributed<2> problem(box_on_floor<2>(8), "extrapolation");
  auto            &matrices = problem.discretization.matrices();
  ASSERT_GT(MassSolver<2>(matrices, {}).smallest_ratio(), 0.);
  // With half of its diagonal the mass is negative where neighbours move against each other.
  for (unsigned int node = 0; node < matrices.pattern.n_local; ++node)
    if (!matrices.pattern.is_empty(node))
      matrices.mass[matrices.pattern.row_start[node]] *= 0.5;
  EXPECT_LT(MassSolver<2>(matrices, {}).smallest_ratio(), 0.);
}

TEST(MassStructure, RefusesOneLayer)
{
  for (const std::string construction : {"extrapolation", "macro-elements"})
    EXPECT_NE(refusal(box_on_floor<2>(1), construction).find("two layers of cells"),
              std::string::npos)
      << construction;
}

TEST(MassStructure, RefusesWhatIsNotPositiveDefinite)
{
  // With contact all around, the inner cells would have to carry an inertia beyond their size.
  BodyDescription<3> body  = box<3>();
  box_of(body).repetitions = {{4, 5, 4}};
  const auto scene = contact_scene<3>(body, {sphere<3>(dealii::Point<3>(0.5, 0.5, 0.5), 3., true)});
  for (const std::string construction : {"minimisation", "macro-elements"})
    EXPECT_NE(refusal(scene, construction).find("not positive definite"), std::string::npos)
      << construction;
}

TEST(MassStructure, MacroElementsBesidePrescribedNodes)
{
  // The corner is held and no contact node, but it lies on the contact surface: it loses its mass
  // like the others.
  Scene<2> scene            = box_on_floor<2>(3);
  scene.bodies[0].dirichlet = {{0, {{"0", "0"}}}};
  const Redistributed<2> problem(scene, "macro-elements");
  const auto            &matrices = problem.discretization.matrices();
  const unsigned int     n        = dealii::Utilities::MPI::sum(
    static_cast<unsigned int>(matrices.massless_nodes.size()), MPI_COMM_WORLD);
  EXPECT_EQ(n, problem.surface.n_global_nodes() + 1);
  EXPECT_GT(MassSolver<2>(matrices, {}).smallest_ratio(), 0.05);
}

TEST(MassStructure, RefusesABodyOfContactNodesAlone)
{
  BodyDescription<2> body  = box<2>();
  box_of(body).repetitions = {{3, 1}};
  const auto scene = contact_scene<2>(body, {sphere<2>(dealii::Point<2>(0.5, 0.5), 3., true)});
  for (const std::string construction : {"zero", "extrapolation", "minimisation", "macro-elements"})
    EXPECT_NE(refusal(scene, construction).find("no mass at all"), std::string::npos)
      << construction;
}

TEST(MassStructure, RefusesHangingNodesInMacroElements)
{
  const auto scene = contact_scene<2>(box_with_hanging_nodes<2>(), {floor_at<2>(0.)}, {2});
  EXPECT_NE(refusal(scene, "macro-elements").find("hanging node"), std::string::npos);
}

TEST(MassStructure, RefusesWithoutContactNodes)
{
  Scene<2> scene = box_on_floor<2>(3);
  scene.pairs.clear();
  EXPECT_NE(refusal(scene, "extrapolation").find("no node can come into contact"),
            std::string::npos);
}
