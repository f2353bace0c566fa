// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The levels of multigrid: the energy of a coarse field is that of the fine field that follows it,
// also where contact holds entries and coarse fields move what is free only. Both sides are
// computed independently; they agree to single precision, in which transfer works.

#include "level_problems.h"

#include <signorini/multigrid/free_space.h>
#include <signorini/multigrid/held_correction.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double accuracy_of_energies = 2e-5;

  /** Without symmetry, the same on any number of processes but for the numbering of nodes. */
  template <int dim>
  LevelVector<float> irregular_vector(const LevelHierarchy<dim> &hierarchy,
                                      const unsigned int         level)
  {
    LevelVector<float> result  = hierarchy.template make_vector<float>(level);
    const NodePattern &pattern = hierarchy.matrices(level).pattern;
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        result[4 * node + c] =
          std::sin(1. + 3. * pattern.partitioner->local_to_global(dim * node + c));
    return result;
  }

  template <int dim>
  Vector in_double(const ElasticMatrices<dim> &matrices, const LevelVector<float> &vector)
  {
    Vector result(matrices.pattern.partitioner);
    for (unsigned int node = 0; node < matrices.pattern.n_owned; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        result.local_element(dim * node + c) = vector[4 * node + c];
    return result;
  }

  template <int dim>
  double energy(const ElasticMatrices<dim> &matrices, const MatrixSum &sum, const Vector &u)
  {
    Vector force(u);
    matrices.apply(force, u, sum);
    return u * force;
  }

  /** Of a coarser level, where translations may have stress, with the matrix of its cycle. */
  template <int dim>
  double
  energy_of_level(const ElasticMatrices<dim> &matrices, const MatrixSum &sum, const Vector &u)
  {
    const unsigned int             n_owned = matrices.pattern.n_owned;
    const LevelMatrix<dim, double> matrix(matrices, std::vector<char>(n_owned, 1), sum, 1.);
    LevelVector<double>            x(4 * n_owned), residual(4 * n_owned);
    for (unsigned int node = 0; node < n_owned; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        x[4 * node + c] = u.local_element(dim * node + c);
    matrix.subtract_product(x, residual);
    double result = 0.;
    for (unsigned int i = 0; i < x.size(); ++i)
      result -= x[i] * residual[i];
    return dealii::Utilities::MPI::sum(result, u.get_mpi_communicator());
  }

  template <int dim>
  Vector follow(const LevelHierarchy<dim> &hierarchy, LevelVector<float> coarse, unsigned int level)
  {
    for (++level; level < hierarchy.n_levels(); ++level)
      {
        LevelVector<float> fine = hierarchy.template make_vector<float>(level);
        hierarchy.prolongate(level, coarse, fine);
        coarse = fine;
      }
    return in_double<dim>(hierarchy.matrices(level - 1), coarse);
  }

  template <int dim>
  void expect_galerkin_levels(const Scene<dim> &scene, const unsigned int least_levels)
  {
    const LevelProblem<dim> problem(scene);
    const auto             &hierarchy = problem.hierarchy;
    EXPECT_GE(hierarchy.n_levels(), least_levels);
    const MatrixSum sum = problem.step(3.);
    for (unsigned int level = 0; level + 1 < hierarchy.n_levels(); ++level)
      {
        const LevelVector<float> coarse = irregular_vector(hierarchy, level);
        const auto              &here   = hierarchy.matrices(level);
        const double             expected =
          energy(problem.matrices(), sum, follow<dim>(hierarchy, coarse, level));
        EXPECT_NEAR(energy_of_level(here, sum, in_double<dim>(here, coarse)),
                    expected,
                    accuracy_of_energies * expected)
          << "level " << level;
      }
  }

  /** (G P x)'K (G P x), with G by contact coordinates. */
  template <int dim>
  void expect_truncated_energy(const Scene<dim> &scene, const bool sticking)
  {
    const LevelProblem<dim>    problem(scene);
    const auto                &hierarchy = problem.hierarchy;
    const MatrixSum            sum       = problem.step(10.);
    HeldCorrection<dim, float> correction(hierarchy, problem.coordinates, sum, 1.);
    for (const double reach : {0.3, 0.01}) // entries are held, and some let go again
      {
        const Mask mask = problem.mask(reach, sticking);
        correction.set_mask(mask);
        double held_anywhere = 0.;
        for (unsigned int level = 0; level + 1 < hierarchy.n_levels(); ++level)
          {
            const LevelVector<float> coarse = irregular_vector(hierarchy, level);
            const auto              &here   = hierarchy.matrices(level);
            Vector                   fine   = follow<dim>(hierarchy, coarse, level);
            problem.coordinates.displacement_to_contact(fine);
            for (unsigned int i = 0; i < mask.size(); ++i)
              if (mask[i])
                fine.local_element(i) = 0.;
            problem.coordinates.displacement_to_cartesian(fine);
            const double expected = energy(problem.matrices(), sum, fine);

            LevelVector<float> change = hierarchy.template make_vector<float>(level);
            correction.subtract_product(level, coarse, change);
            const Vector x    = in_double<dim>(here, coarse);
            const double free = energy_of_level(here, sum, x),
                         held = -(x * in_double<dim>(here, change));
            EXPECT_NEAR(free + held, expected, accuracy_of_energies * free)
              << "level " << level << ", reach " << reach;
            held_anywhere += std::abs(held) / free;
          }
        EXPECT_GT(held_anywhere, 1e-3) << "nothing was held, and nothing tested";
      }
  }

  /** G of the multigrid is that of contact coordinates, and its transpose is one. */
  template <int dim>
  void expect_projection(const Scene<dim> &scene, const bool sticking)
  {
    const LevelProblem<dim> problem(scene);
    const Mask              mask = problem.mask(0.3, sticking);
    FreeSpace<dim, float>   space(problem.coordinates, problem.matrices().pattern);
    space.set_mask(mask);
    const unsigned int finest = problem.hierarchy.n_levels() - 1;
    LevelVector<float> u = irregular_vector(problem.hierarchy, finest), f = u, projected = u;
    for (unsigned int i = 0; i < f.size(); ++i)
      f[i] = i % 4 < dim ? std::cos(2.F * u[i]) : 0.F;
    space.project(projected);
    Vector expected = in_double<dim>(problem.matrices(), u);
    problem.coordinates.displacement_to_contact(expected);
    for (unsigned int i = 0; i < mask.size(); ++i)
      if (mask[i])
        expected.local_element(i) = 0.;
    problem.coordinates.displacement_to_cartesian(expected);
    Vector       found = in_double<dim>(problem.matrices(), projected);
    const double work  = found * in_double<dim>(problem.matrices(), f);
    space.project_force(f);
    EXPECT_NEAR(in_double<dim>(problem.matrices(), u) * in_double<dim>(problem.matrices(), f),
                work,
                accuracy_of_energies * u.size());
    found -= expected;
    EXPECT_LT(found.linfty_norm(), accuracy_of_energies);
  }
} // namespace

TEST(MultigridLevels, EnergiesAreThoseOfTheFineFields)
{
  expect_galerkin_levels<2>(ball_on_floor<2>(3), 4);
  expect_galerkin_levels<3>(ball_on_floor<3>(2), 3);
  expect_galerkin_levels<2>(adaptive_box_on_floor<2>(), 3);
  expect_galerkin_levels<3>(adaptive_box_on_floor<3>(), 3);
  expect_galerkin_levels<2>(unrefined_cantilever<2>(20), 2);
  expect_galerkin_levels<3>(unrefined_cantilever<3>(5), 2);
}

TEST(MultigridLevels, HeldEntriesChangeCoarseMatricesAsTheTruncatedTransferDoes)
{
  for (const bool sticking : {false, true})
    {
      expect_truncated_energy<2>(ball_on_floor<2>(3), sticking);
      expect_truncated_energy<3>(ball_on_floor<3>(2), sticking);
      expect_truncated_energy<2>(adaptive_box_on_floor<2>(), sticking);
      expect_truncated_energy<3>(adaptive_box_on_floor<3>(), sticking);
      expect_truncated_energy<2>(blocks_on_each_other<2>(2, 10.), sticking);
      expect_truncated_energy<3>(blocks_on_each_other<3>(1, 10.), sticking);
    }
}

TEST(MultigridLevels, FreeSpaceIsThatOfContactCoordinates)
{
  for (const bool sticking : {false, true})
    {
      expect_projection<2>(adaptive_box_on_floor<2>(), sticking);
      expect_projection<3>(ball_on_floor<3>(1), sticking);
      expect_projection<2>(blocks_on_each_other<2>(2, 10.), sticking);
      expect_projection<3>(blocks_on_each_other<3>(1, 10.), sticking);
    }
}
