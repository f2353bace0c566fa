// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Conjugate gradients with a V-cycle take 7 to 22 iterations to ten digits, whatever the Courant
// number (5 to 1e5) and the mesh (coarse and fine, uniform and adaptive, with levels and without),
// with contact and without, with two bodies and a stiffness ratio of 1e3 if the nodes of the softer
// one are held. The bounds are those of
// what is measured, plus one or two.

#include "level_problems.h"

#include <signorini/linear_algebra/conjugate_gradients.h>
#include <signorini/multigrid/geometric_multigrid.h>
#include <signorini/preconditioners/preconditioner_choice.h>
#include <signorini/preconditioners/preconditioners.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double reduction = 1e-10;

  template <int dim>
  unsigned int
  iterations(const LevelProblem<dim> &problem, const double courant_number, const Mask &mask)
  {
    const MatrixSum         sum = problem.step(courant_number);
    const StepOperator<dim> matrix(problem.matrices(), problem.coordinates, sum);
    const auto              preconditioner = make_geometric_multigrid<dim>(
      problem.shared_hierarchy,
      problem.coordinates,
      sum,
      needs_double_precision(problem.discretization, 2. * std::sqrt(sum.stiffness)));
    MaskedPreconditioner &cycle = *preconditioner;
    cycle.set_mask(mask);
    Vector residual = problem.discretization.make_vector(), solution = residual, first = residual;
    const NodePattern &pattern = problem.matrices().pattern;
    for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
      if (!pattern.is_empty(i / dim))
        residual.local_element(i) =
          std::sin(1. + 3. * pattern.partitioner->local_to_global(i)); // all frequencies
    cycle.vmult(first, residual);
    const double norm = std::sqrt(first * residual);
    const auto   report =
      ConjugateGradients().solve(matrix, cycle, solution, residual, reduction * norm, 0., 200);
    EXPECT_TRUE(report.converged);
    return report.iterations;
  }

  template <int dim>
  void expect_few(const Scene<dim>          &scene,
                  const double               reach,
                  const unsigned int         most,
                  const std::vector<double> &courant_numbers = {5., 40., 300., 2500., 1e5})
  {
    const LevelProblem<dim> problem(scene);
    for (const double courant : courant_numbers)
      for (const bool contact : {true, false})
        {
          const unsigned int n = iterations(problem, courant, problem.mask(contact ? reach : -1.));
          EXPECT_LE(n, most) << "Courant number " << courant << (contact ? ", contact" : "");
        }
  }
} // namespace

TEST(MultigridIterations, DoNotDependOnCourantNumberAndMesh)
{
  for (const unsigned int refinements : {3, 5})
    expect_few<2>(ball_on_floor<2>(refinements), 0.05, 23); // cells with flat corners at the rim
  for (const unsigned int refinements : {2, 3})
    expect_few<3>(ball_on_floor<3>(refinements), 0.05, 16);
}

TEST(MultigridIterations, AreFewOnAdaptiveMeshes)
{
  expect_few<2>(adaptive_box_on_floor<2>(), 0.3, 11);
  expect_few<3>(adaptive_box_on_floor<3>(), 0.3, 11);
}

TEST(MultigridIterations, AreFewWithTwoBodies)
{
  for (const double ratio : {1., 1e3})
    {
      expect_few<2>(blocks_on_each_other<2>(4, ratio), 0.3, 14);
      expect_few<3>(blocks_on_each_other<3>(2, ratio), 0.3, 24);
    }
}

TEST(MultigridIterations, AreBoundedWhereASoftBodyCarriesAStiffOne)
{
  // More of them: the better way round is that the nodes of the softer body are held. On coarser
  // levels the stiff body couples nodes of the soft one; a smoother that does not know that
  // amplifies, and the cycle is not positive definite: then this does not converge at all.
  for (const double ratio : {1e-2, 1e-4})
    {
      expect_few<2>(blocks_on_each_other<2>(4, ratio), 0.3, 60);
      expect_few<3>(blocks_on_each_other<3>(1, ratio), 0.3, 110);
    }
  expect_few<2>(ball_on_soft_block<2>(4e3), 0.002, 33);
  expect_few<2>(ball_on_soft_block<2>(4e3), 0.02, 65);
  // Beyond single precision.
  expect_few<2>(blocks_on_each_other<2>(4, 1e-6), 0.3, 110, {300., 2500.});
}

TEST(MultigridIterations, AreFewWithoutCoarserCells)
{
  expect_few<2>(unrefined_cantilever<2>(20), 0.3, 15);
  expect_few<3>(unrefined_cantilever<3>(5), 0.3, 26);
}
