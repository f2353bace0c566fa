// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// A V-cycle as a preconditioner: symmetric and positive definite in the free entries, zero in the
// held ones, whatever units a scene has, and the same for the same mask whatever was held before.

#include "level_problems.h"

#include <signorini/multigrid/geometric_multigrid.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double single_precision = 1e-5;

  template <int dim>
  Vector apply(const GeometricMultigrid<dim, float> &cycle, const Vector &x)
  {
    Vector result(x);
    cycle.vmult(result, x);
    return result;
  }

  template <int dim>
  Vector without(const Mask &mask, Vector x)
  {
    for (unsigned int i = 0; i < mask.size(); ++i)
      if (mask[i])
        x.local_element(i) = 0.;
    return x;
  }

  template <int dim>
  void expect_preconditioner(const Scene<dim> &scene, const bool sticking)
  {
    const LevelProblem<dim> problem(scene);
    for (const double courant : {1., 100., 1e4})
      {
        GeometricMultigrid<dim, float> cycle(
          problem.shared_hierarchy, problem.coordinates, problem.step(courant));
        const Mask   held = problem.mask(0.3, sticking), fewer = problem.mask(0.01);
        const Vector x = irregular_field(problem.discretization, 4.),
                     y = irregular_field(problem.discretization, 9.);
        cycle.set_mask(held);
        const Vector of_x = apply(cycle, x), of_y = apply(cycle, y);
        const double size = std::sqrt((x * of_x) * (y * of_y));
        EXPECT_GT(x * of_x, 0.);
        EXPECT_NEAR(x * of_y, y * of_x, single_precision * size) << "Courant number " << courant;
        for (unsigned int i = 0; i < held.size(); ++i)
          if (held[i])
            {
              EXPECT_EQ(of_x.local_element(i), 0.);
            }
        // What the source has in held entries does not matter.
        Vector other = apply(cycle, without<dim>(held, x));
        other -= of_x;
        EXPECT_LE(other.linfty_norm(), single_precision * of_x.linfty_norm());
        cycle.set_mask(fewer);
        EXPECT_GT(x * apply(cycle, x), 0.);
        cycle.set_mask(held);
        Vector again = apply(cycle, x);
        again -= of_x;
        EXPECT_LE(again.linfty_norm(), single_precision * of_x.linfty_norm());
      }
  }
} // namespace

TEST(MultigridCycle, IsSymmetricAndPositiveDefinite)
{
  for (const bool sticking : {false, true})
    {
      expect_preconditioner<2>(ball_on_floor<2>(3), sticking);
      expect_preconditioner<3>(ball_on_floor<3>(2), sticking);
      expect_preconditioner<2>(adaptive_box_on_floor<2>(), sticking);
      expect_preconditioner<3>(adaptive_box_on_floor<3>(), sticking);
      expect_preconditioner<2>(blocks_on_each_other<2>(2, 10.), sticking);
      expect_preconditioner<3>(blocks_on_each_other<3>(1, 10.), sticking);
    }
}

TEST(MultigridCycle, WorksInAnyUnits)
{
  // Stiffness in pascals and a body of a tenth of a millimetre; forces as small as they come.
  Scene<3> scene                          = ball_on_floor<3>(1);
  scene.bodies[0].material.youngs_modulus = 2e11;
  scene.bodies[0].material.density        = 7800.;
  ball_of(scene.bodies[0]).radius         = 1e-4;
  ball_of(scene.bodies[0]).centre[2]      = 1e-4;
  const LevelProblem<3>        problem(scene);
  GeometricMultigrid<3, float> cycle(
    problem.shared_hierarchy, problem.coordinates, problem.step(50.));
  cycle.set_mask(problem.mask(1e-5));
  Vector x = irregular_field(problem.discretization, 4.);
  for (const double scale : {1e-60, 1e60})
    {
      Vector scaled = x;
      scaled *= scale;
      Vector difference = apply(cycle, scaled);
      difference /= scale;
      const Vector expected = apply(cycle, x);
      difference -= expected;
      EXPECT_LE(difference.linfty_norm(), single_precision * expected.linfty_norm());
    }
}

TEST(MultigridCycle, WorksOnASingleCell)
{
  BodyDescription<2> body  = box<2>();
  box_of(body).repetitions = {{1, 1}};
  const LevelProblem<2>        problem(contact_scene<2>(body, {floor_at<2>(0.)}));
  GeometricMultigrid<2, float> cycle(
    problem.shared_hierarchy, problem.coordinates, problem.step(5.));
  cycle.set_mask(problem.mask(0.01));
  const Vector x = irregular_field(problem.discretization, 4.);
  EXPECT_GT(x * apply(cycle, x), 0.);
}

TEST(MultigridCycle, WorksWhereEveryCoarseNodeIsClamped)
{
  BodyDescription<2> body  = box<2>();
  box_of(body).repetitions = {{1, 1}};
  body.refinements         = 1;
  for (const dealii::types::boundary_id side : {0, 1, 2, 3})
    body.dirichlet.push_back({side, {{"0", "0"}}});
  const LevelProblem<2> problem(contact_scene<2>(body, {floor_at<2>(0.)}));
  ASSERT_EQ(dealii::Utilities::MPI::sum(problem.coordinates.clamped_nodes().size(),
                                        problem.discretization.communicator()),
            8U);
  GeometricMultigrid<2, float> cycle(
    problem.shared_hierarchy, problem.coordinates, problem.step(5.));
  cycle.set_mask(problem.mask(-1.));
  const Vector x = irregular_field(problem.discretization, 4.);
  EXPECT_GT(x * apply(cycle, x), 0.);
}
