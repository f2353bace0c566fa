// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Two ways to the matrix T'(a M + b A)T of two bodies in contact: products, and entries for
// preconditioners. They agree, whichever directions are relative: with friction, without, with
// friction on a part of the surface, and where a tangent is prescribed.

#include "two_bodies.h"

#include <signorini/preconditioners/relative_matrix.h>
#include <signorini/preconditioners/step_operator.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  template <int dim>
  dealii::Point<dim> corner_of(const double lateral, const double height)
  {
    dealii::Point<dim> result;
    for (unsigned int c = 0; c < dim - 1; ++c)
      result[c] = lateral;
    result[dim - 1] = height;
    return result;
  }

  template <int dim>
  std::array<unsigned int, dim> cells(const unsigned int n)
  {
    std::array<unsigned int, dim> result;
    result.fill(n);
    return result;
  }

  /** Meshes that match: then every partner belongs to a single contact node. */
  template <int dim>
  Scene<dim> matching(const std::string &coefficient)
  {
    Scene<dim> scene = stacked<dim>(
      block<dim>("slave", corner_of<dim>(0., 0.), corner_of<dim>(1., 1.), cells<dim>(2)),
      block<dim>("master", corner_of<dim>(0., -1.), corner_of<dim>(1., 0.), cells<dim>(2)));
    scene.pairs[0].friction = {FrictionKind::coulomb, coefficient, "", coefficient != "0"};
    return scene;
  }

  /** A small master, so that some nodes of the slave carry no multiplier. */
  template <int dim>
  Scene<dim> irregular(const std::string &coefficient, const unsigned int n_cells = 3)
  {
    Scene<dim> scene = stacked<dim>(
      block<dim>("slave", corner_of<dim>(0., 0.), corner_of<dim>(1., 1.), cells<dim>(n_cells)),
      block<dim>(
        "master", corner_of<dim>(0.4, -1.), corner_of<dim>(1.3, -0.1), cells<dim>(n_cells - 1)));
    scene.pairs[0].friction = {FrictionKind::coulomb, coefficient, "", coefficient != "0"};
    return scene;
  }

  /** The cells at either contact surface follow each other in the mesh. */
  template <int dim>
  Scene<dim> side_by_side(const unsigned int n_cells)
  {
    Scene<dim> scene = irregular<dim>("0.3", n_cells);
    std::swap(scene.bodies[0], scene.bodies[1]);
    std::swap(scene.pairs[0].slave, scene.pairs[0].master);
    return scene;
  }

  template <int dim>
  void expect_exact_diagonal(const Scene<dim> &scene, const double angle)
  {
    const TwoBodies<dim>    bodies(scene, turn<dim>(angle));
    const StepOperator<dim> matrix(bodies.discretization.matrices(), bodies.coordinates, {2., 0.3});
    Vector diagonal = bodies.discretization.make_vector(), unit = diagonal, product = diagonal;
    matrix.diagonal(diagonal);
    const double scale = diagonal.linfty_norm();
    for (unsigned int i = 0; i < unit.size(); ++i)
      {
        const bool is_owned = unit.in_local_range(i);
        unit                = 0.;
        if (is_owned)
          unit(i) = 1.;
        matrix.vmult(product, unit);
        if (is_owned)
          {
            EXPECT_NEAR(diagonal(i), product(i), 1e-13 * scale)
              << "entry " << i << " at angle " << angle;
          }
      }
  }

  /**
   * The product of the blocks, one by one: those of relative coordinates do not add up to zero in a
   * row, as ElasticMatrices::apply() wants them.
   */
  template <int dim>
  Vector product_of_blocks(const ElasticMatrices<dim> &entries, const Vector &v)
  {
    const NodePattern &pattern = entries.pattern;
    Vector             result(v);
    result = 0.;
    v.update_ghost_values();
    for (unsigned int row = 0; row < pattern.n_owned; ++row)
      for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int column = pattern.columns[k];
              const double       entry  = entries.stiffness[k][dim * d + c];
              result.local_element(dim * row + c) += entry * v.local_element(dim * column + d);
              if (column != row && column < pattern.n_owned)
                result.local_element(dim * column + d) += entry * v.local_element(dim * row + c);
            }
    return result;
  }

  /** R S'(a M + b A)S R' = T'(a M + b A)T with the rotation R to the frames. */
  template <int dim>
  void expect_same_products(const Scene<dim> &scene, const double angle)
  {
    const TwoBodies<dim>       bodies(scene, angle == 0. ? Map<dim>() : turn<dim>(angle));
    const auto                &matrices = bodies.discretization.matrices();
    const StepOperator<dim>    product_form(matrices, bodies.coordinates, {2., 0.3});
    const ElasticMatrices<dim> entries = relative_matrix(matrices, bodies.coordinates, {2., 0.3});

    const Vector w        = irregular_field(bodies.discretization, 5.);
    Vector       expected = bodies.discretization.make_vector();
    product_form.vmult(expected, w);
    Vector v(entries.pattern.partitioner);
    v.copy_locally_owned_data_from(w);
    bodies.coordinates.rotate_from_frames(v);
    Vector found = product_of_blocks(entries, v);
    bodies.coordinates.rotate_to_frames(found);
    const double scale = expected.linfty_norm();
    for (unsigned int i = 0; i < expected.locally_owned_size(); ++i)
      EXPECT_NEAR(found.local_element(i), expected.local_element(i), 1e-13 * scale)
        << "entry " << i;
  }

  // None, everywhere, on a part of the surface.
  const std::array<std::string, 3> coefficients{{"0", "0.3", "max(0, x - 0.4)"}};
} // namespace

TEST(RelativeMatrix, DiagonalIsExactOnMatchingMeshes)
{
  for (const std::string &coefficient : coefficients)
    {
      SCOPED_TRACE(coefficient);
      for (const double angle : {0., 0.7})
        expect_exact_diagonal(matching<2>(coefficient), angle);
      expect_exact_diagonal(matching<3>(coefficient), 0.7);
    }
  Scene<3> prescribed            = matching<3>("0.3");
  prescribed.bodies[0].dirichlet = {{0, {{"-", "0", "-"}}}};
  expect_exact_diagonal(prescribed, 0.);
}

TEST(RelativeMatrix, EntriesGiveTheProducts)
{
  for (const std::string &coefficient : coefficients)
    {
      SCOPED_TRACE(coefficient);
      for (const double angle : {0., 0.7})
        {
          expect_same_products(irregular<2>(coefficient), angle);
          expect_same_products(irregular<3>(coefficient), angle);
        }
    }
  // Processes that have a part of either contact surface, or of a single one.
  expect_same_products(side_by_side<2>(16), 0.7);
  expect_same_products(side_by_side<3>(5), 0.7);
  Scene<3> prescribed            = irregular<3>("0.3");
  prescribed.bodies[0].dirichlet = {{1, {{"-", "0", "-"}}}};
  expect_same_products(prescribed, 0.);
}
