// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The overlap of bodies that their coarse cells show is what a comparison of all pairs of cells
// finds, on boxes in random places, whose cells are known without a mesh: the same point, or none.
// With 90 000 cells per body it takes less time than to make the mesh, while all pairs take some
// hundred times as long.

#include "two_bodies.h"

#include <signorini/base/user_error.h>
#include <signorini/contact/overlap.h>

#include <deal.II/base/timer.h>

#include <gtest/gtest.h>

#include <random>

using namespace signorini;
using namespace signorini::tests;
using dealii::Point;
using dealii::Tensor;

// Of its own: all tests of a folder are compiled as one.
namespace overlap_tests
{
  namespace
  {
    template <int dim>
    BodyDescription<dim> placed(BodyDescription<dim>                                body,
                                const std::array<double, Placement<dim>::n_angles> &degrees,
                                const Tensor<1, dim>                               &translation)
    {
      body.placement = Placement<dim>(degrees, Point<dim>(), translation);
      return body;
    }


    /** A box of random size, cells, rotation and place; mostly near the origin. */
    template <int dim>
    BodyDescription<dim> random_box(std::mt19937 &generator)
    {
      std::uniform_real_distribution<double>       unit(0., 1.);
      std::uniform_int_distribution<unsigned int>  repetitions(1, 5);
      Point<dim>                                   upper;
      std::array<unsigned int, dim>                cells;
      std::array<double, Placement<dim>::n_angles> degrees;
      Tensor<1, dim>                               translation;
      for (unsigned int c = 0; c < dim; ++c)
        {
          upper[c]       = 0.3 + unit(generator);
          cells[c]       = repetitions(generator);
          translation[c] = 1.6 * unit(generator);
        }
      for (double &angle : degrees)
        angle = 360. * unit(generator);
      return placed(block<dim>("box", Point<dim>(), upper, cells), degrees, translation);
    }


    /** Whether a point is in a cell of a box by more than a twentieth of it, without a mesh. */
    template <int dim>
    bool in_a_cell(const BodyDescription<dim> &box, const Point<dim> &point)
    {
      const Point<dim> x = box.placement.pull_back(point);
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double cells = x[c] / box_of(box).upper_corner[c] * box_of(box).repetitions[c];
          const double part  = cells - std::floor(cells);
          if (cells < 0. || cells > box_of(box).repetitions[c] || part < 0.05 || part > 0.95)
            return false;
        }
      return true;
    }


    /** The first centre or vertex of a cell of a body that is in a cell of the other. */
    template <int dim>
    std::optional<Point<dim>>
    first_inside(const Mesh<dim> &mesh, const unsigned int body, const unsigned int other)
    {
      for (const auto &cell : mesh.triangulation().cell_iterators_on_level(0))
        if (cell->material_id() == body)
          {
            if (in_a_cell(mesh.bodies()[other], cell->center()))
              return cell->center();
            for (const unsigned int v : cell->vertex_indices())
              if (in_a_cell(mesh.bodies()[other], cell->vertex(v)))
                return cell->vertex(v);
          }
      return {};
    }


    template <int dim>
    void expect_the_same_as_all_pairs()
    {
      std::mt19937       generator(7);
      unsigned int       n_overlaps = 0;
      const unsigned int n_trials   = 100;
      for (unsigned int trial = 0; trial < n_trials; ++trial)
        {
          std::vector<BodyDescription<dim>> bodies = {random_box<dim>(generator),
                                                      random_box<dim>(generator)};
          for (auto &body : bodies)
            body.refinements = trial % 2;
          const Mesh<dim> mesh(bodies, MPI_COMM_WORLD);
          auto            expected = first_inside(mesh, 0, 1);
          if (!expected)
            expected = first_inside(mesh, 1, 0);
          EXPECT_EQ(find_deep_overlap(mesh, 0, 1), expected) << trial;
          n_overlaps += expected.has_value();
        }
      EXPECT_GT(n_overlaps, n_trials / 5);
      EXPECT_LT(n_overlaps, n_trials * 4 / 5);
    }
  } // namespace


  TEST(Overlap, IsWhatAllPairsOfCellsShow)
  {
    expect_the_same_as_all_pairs<2>();
    expect_the_same_as_all_pairs<3>();
  }


  TEST(Overlap, OfManyCellsIsFoundFasterThanTheirMeshIsMade)
  {
    // Side by side and turned, so that the boxes around them have much in common.
    const auto cells = std::array<unsigned int, 2>{{300, 300}};
    const auto left =
      placed(block<2>("left", {-2., 0.}, {-0.001, 2.}, cells), {{40.}}, Tensor<1, 2>());
    const auto right =
      placed(block<2>("right", {0., 0.}, {2., 2.}, cells), {{40.}}, Tensor<1, 2>());
    dealii::Timer timer;
    const Mesh<2> mesh({left, right}, MPI_COMM_WORLD);
    const double  time_of_mesh = timer.cpu_time();
    timer.restart();
    EXPECT_FALSE(find_deep_overlap(mesh, 0, 1).has_value());
    EXPECT_LT(timer.cpu_time(), time_of_mesh);
  }


  TEST(Overlap, BodiesWithoutAPairMayOverlap)
  {
    Scene<2>      scene = stacked<2>(block<2>("upper", {0., -0.5}, {1., 0.5}, {{3, 3}}),
                                block<2>("lower", {0., -1.}, {1., 0.}, {{2, 2}}));
    const Mesh<2> mesh(scene.bodies, MPI_COMM_WORLD);
    EXPECT_THROW(check_that_bodies_are_apart(mesh, scene.pairs), UserError);
    scene.pairs.clear();
    EXPECT_NO_THROW(check_that_bodies_are_apart(mesh, scene.pairs));
  }
} // namespace overlap_tests
