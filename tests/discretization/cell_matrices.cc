// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The matrices of single cells are those of quadrature, to round-off, whether they were computed,
// kept, or scaled from a congruent cell; and cells of a box share one matrix per material, whatever
// their sizes. This is the standard element; see elements.cc for the others.

#include "bodies.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  BodyDescription<dim> standard(BodyDescription<dim> body)
  {
    body.element = ElementKind::standard;
    return body;
  }

  /**
   * Largest relative errors of the mass and of the stiffness of all cells of this process, against
   * the weak form.
   */
  template <int dim>
  std::pair<double, double> errors(const Discretization<dim> &discretization,
                                   const CellMatrices<dim>   &cell_matrices)
  {
    using namespace dealii;
    FEValues<dim>                    fe_values(discretization.mesh().mapping(),
                            discretization.fe(),
                            QGauss<dim>(discretization.mesh().n_quadrature_points()),
                            update_values | update_gradients | update_JxW_values);
    const FEValuesExtractors::Vector u(0);
    std::pair<double, double>        result{0., 0.};
    for (const auto &cell : discretization.mesh().triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          const Material &material = discretization.mesh().bodies()[cell->material_id()].material;
          const auto      matrix   = cell_matrices.of(cell);
          double mass_error = 0., mass_size = 0., stiffness_error = 0., stiffness_size = 0.;
          for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
            for (unsigned int j = 0; j < fe_values.dofs_per_cell; ++j)
              {
                double mass = 0., stiffness = 0.;
                for (const unsigned int q : fe_values.quadrature_point_indices())
                  {
                    const auto   strain_i = fe_values[u].symmetric_gradient(i, q);
                    const auto   strain_j = fe_values[u].symmetric_gradient(j, q);
                    const double JxW      = fe_values.JxW(q);
                    mass += material.density * (fe_values[u].value(i, q) * fe_values[u].value(j, q))
                            * JxW;
                    stiffness += (2. * material.mu() * (strain_i * strain_j)
                                  + material.lambda() * trace(strain_i) * trace(strain_j))
                                 * JxW;
                  }
                const unsigned int c = i % dim, d = j % dim;
                const auto         block = matrix.stiffness(i / dim, j / dim);
                mass_error               = std::max(
                  mass_error, std::abs(mass - (c == d ? matrix.mass(i / dim, j / dim) : 0.)));
                mass_size = std::max(mass_size, std::abs(mass));
                stiffness_error =
                  std::max(stiffness_error, std::abs(stiffness - block[dim * d + c]));
                stiffness_size = std::max(stiffness_size, std::abs(stiffness));
              }
          result.first  = std::max(result.first, mass_error / mass_size);
          result.second = std::max(result.second, stiffness_error / stiffness_size);
        }
    return result;
  }

  /** Twice: when they are computed, and when they are found again. */
  template <int dim>
  void expect_matrices_of_quadrature(const Discretization<dim> &discretization,
                                     const CellMatrices<dim>   &cell_matrices)
  {
    for (unsigned int k = 0; k < 2; ++k)
      {
        const auto [mass, stiffness] = errors(discretization, cell_matrices);
        EXPECT_LT(mass, 1e-13);
        EXPECT_LT(stiffness, 1e-13);
      }
  }

  template <int dim>
  unsigned int n_owned_cells(const Discretization<dim> &discretization)
  {
    return discretization.mesh().triangulation().n_locally_owned_active_cells();
  }

  template <int dim>
  void expect_one_matrix_for_a_box()
  {
    BodyDescription<dim> box    = standard(box_with_hanging_nodes<dim>()); // three sizes of cells
    box_of(box).upper_corner[1] = 1.3;
    box_of(box).lower_corner[0] = 0.1;
    const Assembled<dim>    assembled(box);
    const CellMatrices<dim> fresh(
      assembled.scene.bodies, assembled.discretization.mesh().mapping(), 2);
    expect_matrices_of_quadrature(assembled.discretization, fresh);
    EXPECT_EQ(fresh.n_kept(), 1u);
    EXPECT_EQ(assembled.discretization.mesh().cell_matrices().n_kept(), 1u);
  }
} // namespace

TEST(CellMatrices, ABoxNeedsOne)
{
  expect_one_matrix_for_a_box<2>();
  expect_one_matrix_for_a_box<3>();
}

TEST(CellMatrices, DependOnMaterialAndShape)
{
  BodyDescription<3> soft = standard(box_with_hanging_nodes<3>()), hard = standard(box<3>()),
                     turned      = standard(box<3>());
  box_of(hard).lower_corner[2]   = 1.;
  box_of(hard).upper_corner[2]   = 2.;
  hard.material                  = {7000., 0.1, 9.};
  box_of(turned).lower_corner[0] = 3.;
  box_of(turned).upper_corner[0] = 4.;
  turned.placement = Placement<3>({{0., 30., 10.}}, dealii::Point<3>(), dealii::Tensor<1, 3>());
  const Assembled<3>    assembled(scene_of<3>({soft, hard, turned}));
  const CellMatrices<3> fresh(assembled.scene.bodies, assembled.discretization.mesh().mapping(), 2);
  expect_matrices_of_quadrature(assembled.discretization, fresh);
  EXPECT_LE(fresh.n_kept(), 3u);
  EXPECT_GE(dealii::Utilities::MPI::sum(fresh.n_kept(), MPI_COMM_WORLD), 3u);
}

TEST(CellMatrices, OfDistortedAndOfCurvedCells)
{
  for (const CellGeometry mapping : {CellGeometry::linear, CellGeometry::curved})
    {
      BodyDescription<3> body = standard(ball<3>(1));
      body.local_refinements  = 1;
      body.refine_where       = "0.7 - z + 0.2*x";
      Scene<3> scene          = scene_of<3>({body});
      scene.mapping           = mapping;
      const Assembled<3> assembled(scene);
      const auto        &discretization = assembled.discretization;
      expect_matrices_of_quadrature(discretization, discretization.mesh().cell_matrices());
      EXPECT_GT(discretization.mesh().cell_matrices().n_kept(), 1u);
      EXPECT_LE(discretization.mesh().cell_matrices().n_kept(), n_owned_cells(discretization));
    }
  Scene<2> scene = scene_of<2>({standard(ball<2>(2))});
  scene.mapping  = CellGeometry::curved;
  const Assembled<2> disc(scene);
  expect_matrices_of_quadrature(disc.discretization, disc.discretization.mesh().cell_matrices());
}

// Parents are what a coarser mesh is made of: in the plane four times the mass of a child, and the
// same stiffness.
TEST(CellMatrices, OfParents)
{
  const Assembled<2> assembled(box_with_hanging_nodes<2>());
  const auto        &provider  = assembled.discretization.mesh().cell_matrices();
  unsigned int       n_parents = 0;
  for (const auto &cell : assembled.discretization.mesh().triangulation().active_cell_iterators())
    if (cell->is_locally_owned() && cell->level() > 0)
      {
        ++n_parents;
        const double mass      = provider.of(cell).mass(1, 2),
                     stiffness = provider.of(cell).stiffness(1, 2)[1];
        EXPECT_NEAR(provider.of(cell->parent()).mass(1, 2), 4. * mass, 1e-14 * mass);
        EXPECT_NEAR(
          provider.of(cell->parent()).stiffness(1, 2)[1], stiffness, 1e-13 * std::abs(stiffness));
      }
  EXPECT_GT(dealii::Utilities::MPI::sum(n_parents, MPI_COMM_WORLD), 0u);
}

TEST(CellMatrices, KeepNoMoreThanTheyMay)
{
  Scene<3> scene = scene_of<3>({standard(ball<3>(1))});
  scene.mapping  = CellGeometry::curved;
  const Assembled<3> assembled(scene);
  const auto        &discretization = assembled.discretization;
  CellMatrices<3>    few(assembled.scene.bodies,
                      discretization.mesh().mapping(),
                      discretization.mesh().n_quadrature_points(),
                      5);
  expect_matrices_of_quadrature(discretization, few);
  EXPECT_LE(few.n_kept(), 6u) << "the cells in the middle have one shape, and are not curved";
  EXPECT_GE(few.n_kept(), std::min(5u, n_owned_cells(discretization)));
  const std::size_t n_kept = few.n_kept();
  few.forget_unused(); // all curved ones were used; the one shape is that of a mesh
  EXPECT_LE(few.n_kept(), n_kept);
  EXPECT_GE(few.n_kept() + 1, n_kept);
  few.forget_unused(); // none since
  EXPECT_LE(few.n_kept(), 2u);
  expect_matrices_of_quadrature(discretization, few);
}
