// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The patch test: rigid motions cause no forces, a linear displacement causes none inside, and its
// energy is the volume times the density of energy, on distorted meshes and with hanging nodes.
// These are what convergence needs, and linear displacements are in the space of the finite
// elements, so that all holds to round-off.

#include "bodies.h"

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** A linear displacement and its density of energy for E = 500, nu = 0.3. */
  template <int dim>
  std::array<std::string, dim> linear_displacement()
  {
    if constexpr (dim == 2)
      return {{"0.3*x - 0.1*y", "0.5*x + 0.2*y"}};
    else
      return {{"0.3*x - 0.1*y + 0.7*z", "0.5*x + 0.2*y", "-0.4*z + 0.1*x + 0.6*y"}};
  }

  template <int dim>
  double energy_density(const Material &material)
  {
    const double trace  = dim == 2 ? 0.5 : 0.1;
    double       square = 0.3 * 0.3 + 0.2 * 0.2 + 2. * 0.2 * 0.2;
    if (dim == 3)
      square += 0.4 * 0.4 + 2. * (0.4 * 0.4 + 0.3 * 0.3);
    return 0.5 * material.lambda() * trace * trace + material.mu() * square;
  }

  template <int dim>
  void expect_symmetric_stiffness(const Discretization<dim> &discretization)
  {
    const Vector x = irregular_field(discretization, 3.), y = irregular_field(discretization, 7.);
    const double xAx = x * stiffness_times(discretization, x),
                 yAy = y * stiffness_times(discretization, y);
    EXPECT_GT(xAx, 0.);
    EXPECT_NEAR(x * stiffness_times(discretization, y),
                y * stiffness_times(discretization, x),
                1e-13 * std::sqrt(xAx * yAy));
  }

  /** A scale of nodal forces: those of an irregular displacement. */
  template <int dim>
  double force_scale(const Discretization<dim> &discretization)
  {
    return stiffness_times(discretization, irregular_field(discretization, 3.)).linfty_norm();
  }

  template <int dim>
  void expect_no_force(const Discretization<dim>          &discretization,
                       const std::array<std::string, dim> &motion)
  {
    EXPECT_LT(stiffness_times(discretization, field<dim>(discretization, motion)).linfty_norm(),
              1e-12 * force_scale(discretization))
      << motion[0] << "; " << motion[1];
  }

  template <int dim>
  void expect_no_force_of_rigid_motions(const Discretization<dim> &discretization)
  {
    if constexpr (dim == 2)
      {
        expect_no_force<2>(discretization, {{"1", "0"}});
        expect_no_force<2>(discretization, {{"0", "1"}});
        expect_no_force<2>(discretization, {{"-y", "x"}});
      }
    else
      {
        expect_no_force<3>(discretization, {{"1", "0", "0"}});
        expect_no_force<3>(discretization, {{"0", "1", "0"}});
        expect_no_force<3>(discretization, {{"0", "0", "1"}});
        expect_no_force<3>(discretization, {{"-y", "x", "0"}});
        expect_no_force<3>(discretization, {{"z", "0", "-x"}});
        expect_no_force<3>(discretization, {{"0", "-z", "y"}});
      }
  }

  /** The patch test; `inside` tells the interior nodes by their place. */
  template <int dim>
  void expect_patch_test(const Discretization<dim>                             &discretization,
                         const std::function<bool(const dealii::Point<dim> &)> &inside)
  {
    const Vector u      = field<dim>(discretization, linear_displacement<dim>());
    const Vector forces = stiffness_times(discretization, u);
    const double scale  = force_scale(discretization);
    EXPECT_GT(forces.linfty_norm(), 1e-3 * scale) << "the boundary is pulled";
    const double n_inside = sum_over_nodes(discretization, [&](const unsigned int node) {
      if (!inside(discretization.node_positions()[node]))
        return 0.;
      for (unsigned int c = 0; c < dim; ++c)
        EXPECT_LT(std::abs(forces.local_element(dim * node + c)), 1e-12 * scale)
          << discretization.node_positions()[node];
      return 1.;
    });
    EXPECT_GT(n_inside, 0.);

    const Material &material = discretization.mesh().bodies()[0].material;
    const double    volume   = total_mass(discretization) / material.density;
    EXPECT_NEAR(0.5 * (u * forces), volume * energy_density<dim>(material), 1e-12 * (u * forces));
  }

  template <int dim>
  void expect_all(const BodyDescription<dim>                            &body,
                  const std::function<bool(const dealii::Point<dim> &)> &inside)
  {
    const Assembled<dim> assembled(body);
    expect_symmetric_stiffness(assembled.discretization);
    expect_no_force_of_rigid_motions(assembled.discretization);
    expect_patch_test<dim>(assembled.discretization, inside);
  }

  template <int dim>
  bool inside_unit_box(const dealii::Point<dim> &p)
  {
    for (unsigned int c = 0; c < dim; ++c)
      if (p[c] < 1e-10 || p[c] > 1. - 1e-10)
        return false;
    return true;
  }

  template <int dim>
  bool inside_unit_ball(const dealii::Point<dim> &p)
  {
    dealii::Point<dim> centre;
    centre[dim - 1] = 1.;
    return p.distance(centre) < 1. - 1e-10;
  }

  template <int dim>
  BodyDescription<dim> ball_with_hanging_nodes(const std::string &where)
  {
    BodyDescription<dim> body = ball<dim>(1);
    body.local_refinements    = 1;
    body.refine_where         = where;
    return body;
  }
} // namespace

TEST(Stiffness, OfABox)
{
  expect_all<2>(box<2>(), inside_unit_box<2>);
  expect_all<3>(box<3>(), inside_unit_box<3>);
}

TEST(Stiffness, OfABoxWithHangingNodes)
{
  expect_all<2>(box_with_hanging_nodes<2>(), inside_unit_box<2>);
  expect_all<3>(box_with_hanging_nodes<3>(), inside_unit_box<3>);
}

TEST(Stiffness, OnDistortedCells)
{
  expect_all<2>(ball<2>(2), inside_unit_ball<2>);
  expect_all<3>(ball<3>(1), inside_unit_ball<3>);
}

// Hanging nodes of a round body have to lie on the straight edges and faces of the coarser
// neighbours: only then is the mesh without gaps, and a linear function the same from both sides.
TEST(Stiffness, OnDistortedCellsWithHangingNodes)
{
  expect_all<2>(ball_with_hanging_nodes<2>("0.7 - y"), inside_unit_ball<2>);
  expect_all<3>(ball_with_hanging_nodes<3>("0.7 - z + 0.2*x"), inside_unit_ball<3>);
}

TEST(Stiffness, PoissonsRatioZeroDecouplesTheAxes)
{
  BodyDescription<2> strip      = box<2>();
  strip.material.poissons_ratio = 0.;
  const Assembled<2> assembled(strip);
  const Vector       u      = field<2>(assembled.discretization, {{"x", "0"}});
  const Vector       forces = stiffness_times(assembled.discretization, u);
  for (unsigned int node = 0; node < assembled.discretization.matrices().pattern.n_owned; ++node)
    EXPECT_NEAR(forces.local_element(2 * node + 1), 0., 1e-10);
  EXPECT_NEAR(u * forces, 500., 1e-9);
}
