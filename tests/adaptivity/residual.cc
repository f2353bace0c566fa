// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The parts of the residual estimate for displacements whose residuals are known: zero where the
// stress is constant and in balance, the exact integrals where it is not, also on meshes with
// hanging nodes and on several processes.

#include "../contact/contact_scene.h"

#include <signorini/adaptivity/residual_estimate.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr double E = 500., nu = 0.3, rho = 2.;
  const Material   material{E, nu, rho};

  double sum_of(const dealii::Vector<double> &squares)
  {
    return dealii::Utilities::MPI::sum(squares.l1_norm(), MPI_COMM_WORLD);
  }
} // namespace

TEST(Residual, InteriorOfABilinearDisplacement)
{
  BodyDescription<2> body = box_with_hanging_nodes<2>();
  body.element            = ElementKind::standard; // an enhanced one makes a bending of it
  const Assembled<2> problem(body);
  const auto        &discretization = problem.discretization;
  const Vector       u =
    discretization.interpolate_hanging_nodes(field<2>(discretization, {{"x*y", "0"}}));
  const Vector force =
    discretization.interpolate_hanging_nodes(field<2>(discretization, {{"3", "0"}}));
  dealii::Vector<double> squares(discretization.mesh().triangulation().n_active_cells());
  const CellNeighbors<2> mesh(discretization);
  add_interior_residual(StressVectors<2>(mesh, u), force, ResidualWeights{}, squares);
  // div sigma = (0, lambda + mu), rho q = (6, 0), with the weight h^2 / mu.
  double volume_by_size = 0.;
  for (const auto &cell : discretization.mesh().triangulation().active_cell_iterators())
    if (cell->is_locally_owned())
      volume_by_size += std::pow(cell->measure(), 2);
  volume_by_size        = dealii::Utilities::MPI::sum(volume_by_size, MPI_COMM_WORLD);
  const double residual = std::pow(material.lambda() + material.mu(), 2) + 36.;
  EXPECT_NEAR(sum_of(squares), residual * volume_by_size / material.mu(), 1e-10 * sum_of(squares));

  dealii::Vector<double> jumps(squares.size());
  add_stress_jumps(StressVectors<2>(mesh, u), ResidualWeights{}, jumps);
  EXPECT_LT(sum_of(jumps), 1e-20 * sum_of(squares)); // the bilinear function is smooth
}

TEST(Residual, JumpsOfAKink)
{
  // Hanging nodes lie in the left half, away from the kink, and cells of different size meet the
  // kink on both sides.
  BodyDescription<3> body = box<3>();
  body.local_refinements  = 1;
  body.refine_where       = "0.3 - y";
  const Assembled<3> problem(body);
  const auto        &discretization = problem.discretization;
  const Vector       u              = discretization.interpolate_hanging_nodes(
    field<3>(discretization, {{"0", "0", "max(x - 0.5, 0)"}}));
  const CellNeighbors<3> mesh(discretization);
  dealii::Vector<double> jumps(discretization.mesh().triangulation().n_active_cells());
  add_stress_jumps(StressVectors<3>(mesh, u), ResidualWeights{}, jumps);
  // sigma_xz jumps by mu: mu^2 h / mu over the area 1, one half of it with h = 1/4, the other with
  // h = 1/2.
  EXPECT_NEAR(sum_of(jumps), material.mu() * 0.5 * (0.25 + 0.5), 1e-10 * material.mu());
}

// With a step, what is larger than the way of a shear wave in half of it has the weight of the
// mass.
TEST(Residual, WeightsOfAStep)
{
  const double          wave = std::sqrt(material.mu() / rho), tau = 0.02;
  const ResidualWeights rest, step{tau};
  for (const double h : {0.1 * tau * wave, 0.49 * tau * wave})
    {
      EXPECT_NEAR(step.cell(material, h), 4. * rest.cell(material, h), 1e-12);
      EXPECT_NEAR(step.face(material, h), 4. * rest.face(material, h), 1e-12);
    }
  EXPECT_NEAR(step.cell(material, 1e3), tau * tau / rho, 1e-12);
  EXPECT_NEAR(step.face(material, 1e3), 2. * tau / std::sqrt(rho * material.mu()), 1e-12);
}

// A body in free fall, whatever its mesh, has no residual; a traction that is not there does.
TEST(Residual, BoundaryOfABodyUnderTraction)
{
  BodyDescription<2> body = box_with_hanging_nodes<2>();
  body.traction.push_back({1, {{"7", "0"}}});
  body.dirichlet.push_back({0, {{"0", "-"}}});
  body.dirichlet.push_back({2, {{"-", "0"}}});
  const ContactProblem<2> problem(contact_scene<2>(body, {}));
  const auto             &discretization = problem.discretization;
  const auto              estimate       = [&](const std::array<std::string, 2> &u) {
    const ForceBalance balance = balance_at_rest(
      discretization, problem.surface, field<2>(discretization, u), discretization.make_vector());
    return sum_of(ResidualEstimate(discretization, problem.surface, problem.dirichlet)
                    .squares(balance, ResidualWeights{}));
  };
  // Uniaxial plane stress in plane strain: sigma_xx = 7, sigma_yy = 0.
  const std::string along  = std::to_string(1e9 * 7. * (1. - nu * nu) / E) + "e-9*x",
                    across = std::to_string(-1e9 * 7. * nu * (1. + nu) / E) + "e-9*y";
  EXPECT_LT(estimate({{along, across}}), 1e-20);
  // Without deformation the residual is the traction: 49 h / mu on each face at x = 1.
  double length_by_size = 0.;
  for (const auto &cell : discretization.mesh().triangulation().active_cell_iterators())
    if (cell->is_locally_owned() && cell->face(1)->at_boundary())
      length_by_size += std::pow(cell->face(1)->measure(), 2);
  length_by_size = dealii::Utilities::MPI::sum(length_by_size, MPI_COMM_WORLD);
  EXPECT_NEAR(estimate({{"0", "0"}}), 49. * length_by_size / material.mu(), 1e-10);
}
