// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What a solver feels of small cells. On a uniform mesh, also of a slender body, the Courant
// number; where only a corner is fine, no more than the cells of the corner, however small they
// are. Graded is what differs from most cells of its body, whatever other bodies are.

#include "bodies.h"

#include <signorini/discretization/graded_mesh.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  class GradedMesh : public testing::Test
  {
  protected:
    /** 16 cells across, those within a distance of a corner finer. */
    static BodyDescription<dim> box(const double near, const unsigned int n_refinements)
    {
      BodyDescription<dim> body = tests::box<dim>();
      body.refinements          = 3;
      body.local_refinements    = n_refinements;
      body.refine_where         = std::to_string(near) + " - max(x, y" + (dim == 3 ? ", z)" : ")");
      return body;
    }

    static Mesh<dim> mesh_of(const std::vector<BodyDescription<dim>> &bodies)
    {
      return Mesh<dim>(bodies, MPI_COMM_WORLD);
    }

    /** Of which the largest Courant number is one. */
    static double step_of_one(const Mesh<dim> &mesh) { return 1. / mesh.courant_number(1.); }
  };

  template <typename T>
  class GradedMeshOf : public GradedMesh<T::value>
  {
  };
  using GradedDimensions =
    testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
} // namespace

TYPED_TEST_SUITE(GradedMeshOf, GradedDimensions);

TYPED_TEST(GradedMeshOf, UniformOnesCountAsTheyAre)
{
  auto slender                    = this->box(0., 0);
  box_of(slender).repetitions[0]  = 40;
  box_of(slender).upper_corner[0] = 40.;
  slender.refinements             = 1;
  for (const auto &body : {this->box(0., 0), slender})
    {
      const auto   mesh = this->mesh_of({body});
      const double one  = this->step_of_one(mesh);
      for (const double number : {0.3, 1., 7., 40., 1e6})
        EXPECT_NEAR(effective_courant_number(mesh, number * one), number, 1e-12 * number);
      EXPECT_EQ(grading(mesh), 0.);
    }
}

TYPED_TEST(GradedMeshOf, SmallCellsCountAsFarAsTheyGo)
{
  // Within 0.04 of the corner cells are 16 times finer, ten of them across, then less.
  const auto   mesh = this->mesh_of({this->box(0.04, 4)});
  const double step = 320. * this->step_of_one(mesh);
  EXPECT_NEAR(mesh.courant_number(step), 320., 1e-9);
  EXPECT_GE(effective_courant_number(mesh, step), 3. * 8.);
  EXPECT_LE(effective_courant_number(mesh, step), 3. * 16.);
  // Where they are the most, they count as they are.
  const auto fine = this->mesh_of({this->box(0.4, 2)});
  EXPECT_NEAR(effective_courant_number(fine, 320. * this->step_of_one(fine)), 320., 1e-9);
}

TYPED_TEST(GradedMeshOf, TheOtherCellsAreCounted)
{
  constexpr int dim       = TypeParam::value;
  const double  new_cells = std::pow(2., dim), all = std::pow(16., dim) - 1. + new_cells;
  EXPECT_NEAR(grading(this->mesh_of({this->box(0.04, 1)})), new_cells / all, 1e-12);
  EXPECT_NEAR(
    grading(this->mesh_of({this->box(0.9, 1)})),
    1. - std::pow(28., dim) / (std::pow(16., dim) + (1. - 1. / new_cells) * std::pow(28., dim)),
    1e-12);
}

TYPED_TEST(GradedMeshOf, AStiffBodyOfFewCellsCountsAsItIs)
{
  auto soft = this->box(0., 0), stiff = tests::box<TypeParam::value>();
  stiff.name = "stiff";
  stiff.material.youngs_modulus *= 1e6;
  const auto mesh = this->mesh_of({soft, stiff});
  EXPECT_NEAR(effective_courant_number(mesh, 500. * this->step_of_one(mesh)), 500., 1e-9);
}

TYPED_TEST(GradedMeshOf, OtherBodiesDoNotMakeAMeshGraded)
{
  auto coarse = this->box(0., 0), fine = this->box(0., 0);
  coarse.name        = "coarse";
  fine.name          = "fine";
  coarse.refinements = 1;
  EXPECT_EQ(grading(this->mesh_of({coarse, fine})), 0.);
}
