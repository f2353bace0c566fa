// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Marking is checked against its definition, with indicators that are functions of the place: what
// the bulk criterion chooses, what the limits forbid, and that a mesh which is good enough is kept.
// The numbers are the same on any number of processes.

#include "../discretization/bodies.h"

#include <signorini/adaptivity/mark_cells.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** A box of 16 x 16 cells of level 3, and indicators of its cells. */
  struct Marked
  {
    explicit Marked(const BodyDescription<2> &body = box_of_level_3())
      : scene(scene_of<2>({body}))
      , mesh(scene.bodies, MPI_COMM_WORLD)
    {
      scene.adaptivity.indicator     = IndicatorKind::residual;
      scene.adaptivity.maximum_level = 5;
    }

    static BodyDescription<2> box_of_level_3()
    {
      BodyDescription<2> body = box<2>();
      body.refinements        = 3;
      return body;
    }

    dealii::Vector<double>
    indicator(const std::function<double(const dealii::Point<2> &)> &value) const
    {
      dealii::Vector<double> result(mesh.triangulation().n_active_cells());
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          result(cell->active_cell_index()) = value(cell->center());
      return result;
    }

    MeshChange mark(const std::function<double(const dealii::Point<2> &)> &value,
                    const std::vector<bool>                               &not_to_coarsen = {})
    {
      return mark_cells(mesh, scene.adaptivity, indicator(value), not_to_coarsen);
    }

    unsigned int change()
    {
      mesh.carry_out_flags();
      return mesh.triangulation().n_global_active_cells();
    }

    Scene<2> scene;
    Mesh<2>  mesh;
  };

  double decaying(const dealii::Point<2> &p)
  {
    return std::exp(-3. * p[0] - 0.41 * p[1]);
  }
} // namespace

TEST(Marking, BulkIsTheSmallestSetThatMakesItsPart)
{
  for (const double part : {0.1, 0.5, 0.9, 1.})
    {
      Marked problem;
      problem.scene.adaptivity.refine_fraction  = part;
      problem.scene.adaptivity.coarsen_fraction = 0.;
      const MeshChange    change                = problem.mark(decaying);
      std::vector<double> squares; // of all cells
      for (unsigned int i = 0; i < 256; ++i)
        squares.push_back(std::pow(decaying({(i % 16 + 0.5) / 16., (i / 16 + 0.5) / 16.}), 2));
      std::sort(squares.rbegin(), squares.rend());
      const double total = std::accumulate(squares.begin(), squares.end(), 0.);
      EXPECT_NEAR(change.estimate, std::sqrt(total), 1e-13 * std::sqrt(total));
      double       sum      = 0.;
      unsigned int smallest = 0;
      while (smallest < squares.size() && sum < (1. - 1e-12) * part * total)
        sum += squares[smallest++];
      // A bin of the histogram may hold some more.
      EXPECT_GE(change.n_to_refine, smallest);
      EXPECT_LE(change.n_to_refine, smallest + 12);
      EXPECT_FALSE(change.coarsens());
    }
}

TEST(Marking, LimitsOfLevelsAndCells)
{
  Marked problem;
  problem.scene.adaptivity.maximum_level = 3;
  EXPECT_FALSE(problem.mark(decaying).any());

  problem.scene.adaptivity.maximum_level = 5;
  problem.scene.adaptivity.maximum_cells = 256 + 3 * 20;
  problem.scene.adaptivity.hysteresis    = 0.;
  const MeshChange change                = problem.mark(decaying);
  EXPECT_GT(change.n_to_refine, 10u);
  EXPECT_LE(change.n_to_refine, 20u);

  // Nothing may become coarser than the initial mesh.
  problem.scene.adaptivity.coarsen_fraction = 0.5;
  EXPECT_FALSE(problem.mark([](const auto &p) { return p[0] < 0.1 ? 1. : 1e-6; }).coarsens());
}

TEST(Marking, NothingToSeeIsNoReasonForAChange)
{
  Marked problem;
  for (const MarkingKind marking : {MarkingKind::fixed_fraction, MarkingKind::tolerance})
    {
      problem.scene.adaptivity.marking   = marking;
      problem.scene.adaptivity.tolerance = 1.;
      EXPECT_FALSE(problem.mark([](const auto &) { return 0.; }).any());
    }
}

// The cells that would be refined are at the highest level but for a few: the mesh is good enough.
TEST(Marking, ChangesThatAreNotWorthItAreLeftOut)
{
  Marked     problem;
  const auto peak = [](const dealii::Point<2> &p) {
    return p[0] < 0.25 && p[1] < 0.25 ? 1. : 1e-3;
  };
  problem.scene.adaptivity.maximum_level = 4;
  EXPECT_EQ(problem.mark(peak).n_to_refine, 16u);
  EXPECT_EQ(problem.change(), 256u + 3 * 16);
  problem.scene.adaptivity.refine_fraction = 1.;
  EXPECT_FALSE(problem.mark(peak).any());
  problem.scene.adaptivity.hysteresis = 0.;
  EXPECT_TRUE(problem.mark(peak).refines());
}

TEST(Marking, WhatWasRefinedIsCoarsenedBehindAndWhatIsProtectedStays)
{
  Marked problem;
  EXPECT_TRUE(problem.mark([](const auto &p) { return p[0] < 0.5 ? 1. : 1e-3; }).refines());
  problem.change();
  const auto        moved = [](const dealii::Point<2> &p) { return p[0] > 0.9 ? 1. : 1e-4; };
  std::vector<bool> all(problem.mesh.triangulation().n_active_cells(), true);
  EXPECT_FALSE(problem.mark(moved, all).coarsens());
  const MeshChange change = problem.mark(moved);
  EXPECT_GT(change.n_to_coarsen, 400u);
  EXPECT_EQ(change.n_to_coarsen % 4, 0u);
}

// What may be below 1/32 of the threshold by default, may be below one half if the scene says so.
TEST(Marking, CoarsenRatioIsOfTheThreshold)
{
  Marked problem;
  problem.scene.adaptivity.marking   = MarkingKind::tolerance;
  problem.scene.adaptivity.tolerance = 1.;
  EXPECT_TRUE(problem.mark([](const auto &p) { return p[0] < 0.5 ? 1. : 0.; }).refines());
  const double n_cells = problem.change();
  const auto   behind  = [&](const dealii::Point<2> &p) {
    return std::sqrt((p[0] < 0.5 ? 0.4 : 2.) / n_cells);
  };
  EXPECT_FALSE(problem.mark(behind).coarsens());
  problem.scene.adaptivity.coarsen_ratio = 0.3;
  EXPECT_FALSE(problem.mark(behind).coarsens());
  problem.scene.adaptivity.coarsen_ratio = 0.5;
  EXPECT_GT(problem.mark(behind).n_to_coarsen, 400u);
}

// Cells that are wanted fine are refined whatever their indicator, but not beyond the highest
// level, and at the expense of others if cells are limited.
TEST(Marking, WantedCellsAreRefinedInAnyCase)
{
  Marked            problem;
  std::vector<bool> wanted(problem.mesh.triangulation().n_active_cells());
  for (const auto &cell : problem.mesh.triangulation().active_cell_iterators())
    wanted[cell->active_cell_index()] = cell->center()[0] > 0.9;
  const auto mark = [&](const auto &value) {
    return mark_cells(problem.mesh, problem.scene.adaptivity, problem.indicator(value), {}, wanted)
      .n_to_refine;
  };
  EXPECT_EQ(mark([](const auto &) { return 0.; }), 32u);
  const unsigned int without_limit       = mark(decaying);
  problem.scene.adaptivity.maximum_cells = 256 + 3 * 40;
  EXPECT_GT(without_limit, 40u);
  EXPECT_LE(mark(decaying), 40u);
  EXPECT_GE(mark(decaying), 32u);
  problem.scene.adaptivity.maximum_level = 3;
  EXPECT_EQ(mark(decaying), 0u);
}

// The children of a refined cell have a quarter of its square each, and a fourth of that by the
// order of the method. They must not be taken for too fine.
TEST(Marking, WhatIsCoarsenedIsNotRefinedAtOnce)
{
  for (const MarkingKind marking : {MarkingKind::fixed_fraction, MarkingKind::tolerance})
    {
      Marked problem;
      problem.scene.adaptivity.marking          = marking;
      problem.scene.adaptivity.tolerance        = marking == MarkingKind::tolerance ? 0.01 : 0.;
      problem.scene.adaptivity.coarsen_fraction = 0.5;
      problem.scene.adaptivity.hysteresis       = 0.;
      unsigned int changes                      = 0;
      for (; changes < 30; ++changes)
        {
          dealii::Vector<double> indicator(problem.mesh.triangulation().n_active_cells());
          for (const auto &cell : problem.mesh.triangulation().active_cell_iterators())
            if (cell->is_locally_owned())
              indicator(cell->active_cell_index()) =
                decaying(cell->center()) * std::pow(cell->diameter() / std::sqrt(2.), 2);
          if (!mark_cells(problem.mesh, problem.scene.adaptivity, indicator).any())
            break;
          problem.change();
        }
      EXPECT_LT(changes, 20u) << name_of(marking);
    }
}

TEST(Marking, EqualSharesReachTheTolerance)
{
  Marked problem;
  problem.scene.adaptivity.marking   = MarkingKind::tolerance;
  problem.scene.adaptivity.tolerance = 1.;
  const auto share                   = [](const double factor) {
    return [factor](const dealii::Point<2> &p) { return p[0] < 0.5 ? factor / 16. : 0.1 / 16.; };
  };
  EXPECT_FALSE(problem.mark(share(1.3)).refines()); // the whole is below the tolerance
  EXPECT_EQ(problem.mark(share(1.5)).n_to_refine, 128u);
}
