// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The stress of a linear displacement is constant and known by Hooke's law in terms of E and nu; a
// rigid translation has none.

#include "box_above_floor.h"

#include <signorini/output/cell_stress.h>
#include <signorini/output/mean_strain.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace signorini;
using dealii::SymmetricTensor;

namespace
{
  /** sigma = E/(1+nu) (eps + nu/(1-2nu) tr(eps) I) for E = 7, nu = 0.2. */
  double hooke(const double strain, const double trace, const bool diagonal)
  {
    return 7. / 1.2 * (strain + (diagonal ? 0.2 / 0.6 * trace : 0.));
  }

  template <int dim>
  void expect_stress(const std::array<std::string, dim> &displacement, const Stress &expected)
  {
    const BoxAboveFloor<dim> box;
    const auto              &discretization = box.discretization;
    ASSERT_GT(dealii::Utilities::MPI::max(discretization.hanging_node_constraints().n_constraints(),
                                          MPI_COMM_WORLD),
              0u);
    const Vector moved =
      discretization.interpolate_hanging_nodes(discretization.interpolate({displacement}));
    const MeanStrain<dim> mean_strain(discretization);
    unsigned int          k = 0;
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        {
          const auto strain = mean_strain.of(
            k++, values_at_vertices<dim>(moved, places_of_vertices<dim>(cell, moved)));
          const Stress stress = stress_of<dim>(box.scene.bodies[0].material, strain);
          EXPECT_LT((stress - expected).norm(), 1e-13);
        }
  }
} // namespace

TEST(CellStress, PlaneStrain)
{
  Stress expected;
  expected[0][0] = hooke(0.01, -0.02, true);
  expected[1][1] = hooke(-0.03, -0.02, true);
  expected[2][2] = hooke(0., -0.02, true);
  expected[0][1] = hooke(0.025, -0.02, false);
  EXPECT_NEAR(expected[2][2], 0.2 * (expected[0][0] + expected[1][1]), 1e-15);
  expect_stress<2>({{"0.01*x + 0.02*y", "0.03*x - 0.03*y"}}, expected);
}

TEST(CellStress, ThreeDimensions)
{
  Stress expected;
  expected[0][0] = hooke(0.01, 0.03, true);
  expected[1][1] = hooke(-0.03, 0.03, true);
  expected[2][2] = hooke(0.05, 0.03, true);
  expected[0][1] = hooke(0.025, 0.03, false);
  expected[0][2] = hooke(0.01, 0.03, false);
  expected[1][2] = hooke(-0.02, 0.03, false);
  expect_stress<3>({{"0.01*x + 0.02*y", "0.03*x - 0.03*y - 0.04*z", "0.02*x + 0.05*z"}}, expected);
}

TEST(CellStress, TranslationHasNone)
{
  expect_stress<2>({{"3", "-4"}}, Stress());
  expect_stress<3>({{"3", "-4", "5"}}, Stress());
}

TEST(CellStress, VonMises)
{
  Stress uniaxial, shear;
  uniaxial[1][1] = -3.;
  shear[0][2]    = 2.;
  EXPECT_NEAR(von_mises(uniaxial), 3., 1e-14);
  EXPECT_NEAR(von_mises(shear), 2. * std::sqrt(3.), 1e-14);
  EXPECT_NEAR(von_mises(5. * dealii::unit_symmetric_tensor<3>()), 0., 1e-14);

  // Plane strain: the stress out of the plane counts.
  SymmetricTensor<2, 2> strain;
  strain[0][0] = strain[1][1] = 0.01;
  Material material;
  material.youngs_modulus = 7.;
  material.poissons_ratio = 0.2;
  EXPECT_NEAR(von_mises(stress_of<2>(material, strain)), 7. / 1.2 * 0.01, 1e-14);
}
