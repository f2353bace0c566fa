// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The residual estimate of elements with strain modes:
//
// - the divergence of their stress is that of central differences, on curved cells, too;
// - pure bending is in the space of the enhanced element on a mesh of boxes: nodal values of the
//   exact displacement have no residual, neither inside nor between cells nor on free or loaded
//   surfaces, while those of the standard element have one;
// - the estimate of a smooth solution is a bounded multiple of its error in energy.

#include "../contact/contact_scene.h"
#include "../discretization/direct_solution.h"

#include <signorini/adaptivity/residual_estimate.h>
#include <signorini/finite_elements/cell_strain.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  constexpr ElementKind with_modes[] = {ElementKind::enhanced, ElementKind::mean_dilatation};

  template <int dim>
  struct StressAtPoints
  {
    FourMatrices<dim> stress, K; ///< K: inverse Jacobians
    FourNumbers       volume;
  };

  template <int dim>
  StressAtPoints<dim> stress_at(const CellStrain<dim>                  &strain,
                                const unsigned int                      degree,
                                const typename PointTable<dim>::Points &points)
  {
    const PointTable<dim> polynomials(dealii::FE_Q<dim>(1), points),
      of_map(dealii::FE_Q<dim>(degree), points);
    const auto          jacobian = strain.jacobian(of_map);
    StressAtPoints<dim> result;
    result.K             = cofactors(jacobian);
    result.volume        = determinant<dim>(jacobian, result.K);
    const auto  gradient = strain.gradient(polynomials, result.K);
    FourNumbers trace{};
    for (unsigned int c = 0; c < dim; ++c)
      trace += gradient[c][c] / result.volume;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int i = 0; i < dim; ++i)
        {
          result.stress[c][i] =
            strain.material.mu() * (gradient[c][i] + gradient[i][c]) / result.volume;
          if (c == i)
            result.stress[c][i] += strain.material.lambda() * trace;
        }
    for (auto &row : result.K)
      for (auto &entry : row)
        entry /= result.volume;
    return result;
  }

  template <int dim>
  void expect_divergence_of_differences(const ElementKind element)
  {
    BodyDescription<dim> body = ball<dim>(1);
    body.element              = element;
    Scene<dim> scene          = scene_of<dim>({body});
    scene.mapping             = CellGeometry::curved;
    const Assembled<dim>     problem(scene);
    const CellNeighbors<dim> mesh(problem.discretization);
    const Vector u = mesh.interpolate_hanging_nodes(irregular_field(problem.discretization, 2.));
    typename PointTable<dim>::Points points;
    for (unsigned int q = 0; q < points.size(); ++q)
      for (unsigned int a = 0; a < dim; ++a)
        points[q][a] = 0.2 + 0.15 * q + 0.05 * a;
    const PointTable<dim> polynomials(dealii::FE_Q<dim>(1), points),
      of_map(dealii::FE_Q<dim>(2), points);
    for (const LocalCell<dim> &cell : mesh.cells)
      {
        const CellStrain<dim>     strain(mesh, cell, u);
        const StressAtPoints<dim> here = stress_at(strain, 2, points);
        const auto found = strain.divergence_of_stress(polynomials, of_map, here.K, here.volume);
        FourVectors<dim> expected{};
        constexpr double h = 1e-4;
        for (unsigned int a = 0; a < dim; ++a)
          {
            auto before = points, after = points;
            for (unsigned int q = 0; q < points.size(); ++q)
              {
                before[q][a] -= h;
                after[q][a] += h;
              }
            const auto low = stress_at(strain, 2, before), high = stress_at(strain, 2, after);
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int i = 0; i < dim; ++i)
                expected[c] += here.K[a][i] * (high.stress[c][i] - low.stress[c][i]) / (2. * h);
          }
        double scale = 0.; // of a change of the stress over the cell
        for (unsigned int c = 0; c < dim; ++c)
          scale = std::max(scale, std::abs(here.stress[c][c][0]) / cell.cell->diameter());
        for (unsigned int q = 0; q < points.size(); ++q)
          for (unsigned int c = 0; c < dim; ++c)
            EXPECT_NEAR(found[c][q], expected[c][q], 1e-5 * scale) << name_of(element);
      }
  }

  /** Squared estimate of nodal values. */
  template <int dim>
  double estimate(const BodyDescription<dim>         &body,
                  const std::array<std::string, dim> &displacement)
  {
    const ContactProblem<dim> problem(contact_scene<dim>(body, {}));
    const auto               &discretization = problem.discretization;
    const ForceBalance        balance        = balance_at_rest(discretization,
                                                 problem.surface,
                                                 field<dim>(discretization, displacement),
                                                 discretization.make_vector());
    return dealii::Utilities::MPI::sum(
      ResidualEstimate<dim>(discretization, problem.surface, problem.dirichlet)
        .squares(balance, ResidualWeights{})
        .l1_norm(),
      MPI_COMM_WORLD);
  }

  /** A box, free at its sides, bent by stresses E/100 (last coordinate - 1/2) on its ends. */
  template <int dim>
  BodyDescription<dim> bent_box(const ElementKind element)
  {
    BodyDescription<dim> body    = box<dim>();
    body.element                 = element;
    box_of(body).upper_corner[0] = 3.;
    body.material.poissons_ratio = 0.25;
    const std::string stress     = dim == 2 ? "(5/(1-0.25^2))*(y-0.5)" : "5*(z-0.5)";
    body.traction.resize(2);
    body.traction[0].boundary_id = 0;
    body.traction[1].boundary_id = 1;
    for (unsigned int c = 0; c < dim; ++c)
      body.traction[0].expressions[c] = body.traction[1].expressions[c] = "0";
    body.traction[0].expressions[0] = "-" + stress;
    body.traction[1].expressions[0] = stress;
    return body;
  }

  /** Its displacement; across by nu, in the plane by nu/(1 - nu). */
  template <int dim>
  std::array<std::string, dim> bending()
  {
    if constexpr (dim == 2)
      return {{"0.01*x*(y-0.5)", "-0.005*(x^2 + (y-0.5)^2/3)"}};
    else
      return {{"0.01*x*(z-0.5)", "-0.0025*y*(z-0.5)", "-0.005*(x^2 + 0.25*(z-0.5)^2 - 0.25*y^2)"}};
  }

  template <int dim>
  void expect_no_residual_of_bending()
  {
    const double standard = estimate<dim>(bent_box<dim>(ElementKind::standard), bending<dim>());
    EXPECT_GT(standard, 1e-3);
    EXPECT_LT(estimate<dim>(bent_box<dim>(ElementKind::enhanced), bending<dim>()),
              1e-20 * standard);
  }

  /** Estimate over error of u = (sin(pi x) sin(pi y), 0), both squared, and the squared error. */
  std::pair<double, double> effectivity(const ElementKind element, const unsigned int refinements)
  {
    BodyDescription<2> body = box<2>();
    body.element            = element;
    body.refinements        = refinements;
    const double lambda = body.material.lambda(), mu = body.material.mu();
    const double square = dealii::numbers::PI * dealii::numbers::PI / body.material.density;
    body.body_force[0]  = std::to_string(square * (lambda + 3. * mu)) + "*sin(pi*x)*sin(pi*y)";
    body.body_force[1]  = std::to_string(-square * (lambda + mu)) + "*cos(pi*x)*cos(pi*y)";
    for (unsigned int id = 0; id < 4; ++id)
      body.dirichlet.push_back({id, {{"0", "0"}}});
    const ContactProblem<2> problem(contact_scene<2>(body, {}));
    const auto             &discretization = problem.discretization;
    Loads<2>                loads(discretization);
    const Vector            u = direct_solution<2>(
      discretization, loads.at(0.), discretization.make_vector(), [](const auto &p) {
        return std::min({p[0], p[1], 1. - p[0], 1. - p[1]}) < 1e-10;
      });
    ForceBalance balance =
      balance_at_rest(discretization, problem.surface, u, discretization.make_vector());
    balance.specific_force = field<2>(discretization, body.body_force);
    const double found     = dealii::Utilities::MPI::sum(
      ResidualEstimate<2>(discretization, problem.surface, problem.dirichlet)
        .squares(balance, ResidualWeights{})
        .l1_norm(),
      MPI_COMM_WORLD);

    // Stress against stress, in the norm of the energy.
    const CellNeighbors<2> mesh(discretization);
    const Vector           filled = mesh.interpolate_hanging_nodes(u);
    double                 error  = 0.;
    for (const LocalCell<2> &cell : mesh.cells)
      if (cell.owned)
        {
          const CellStrain<2> strain(mesh, cell, filled);
          const auto         &table    = GaussTables<2>::of_degree(1).interior[0];
          const auto          jacobian = strain.jacobian(table);
          const auto          cofactor = cofactors(jacobian);
          const auto          volume   = determinant<2>(jacobian, cofactor);
          const auto          gradient = strain.gradient(table, cofactor);
          const auto          points =
            table.values(numbers(support_points(discretization.mesh().mapping(), cell.cell)));
          for (unsigned int q = 0; q < 4; ++q)
            {
              const double pi = dealii::numbers::PI, x = pi * points[0][q], y = pi * points[1][q];
              const double xx = gradient[0][0][q] / volume[q] - pi * std::cos(x) * std::sin(y);
              const double yy = gradient[1][1][q] / volume[q];
              const double xy = 0.5
                                * ((gradient[0][1][q] + gradient[1][0][q]) / volume[q]
                                   - pi * std::sin(x) * std::cos(y));
              error +=
                0.25 * volume[q]
                * (2. * mu * (xx * xx + yy * yy + 2. * xy * xy) + lambda * (xx + yy) * (xx + yy));
            }
        }
    error = dealii::Utilities::MPI::sum(error, MPI_COMM_WORLD);
    return {found / error, error};
  }
} // namespace

TEST(StrainModes, DivergenceIsThatOfDifferences)
{
  for (const ElementKind element : with_modes)
    {
      expect_divergence_of_differences<2>(element);
      expect_divergence_of_differences<3>(element);
    }
}

TEST(StrainModes, BendingHasNoResidual)
{
  expect_no_residual_of_bending<2>();
  expect_no_residual_of_bending<3>();
}

TEST(StrainModes, EstimateIsABoundedMultipleOfTheError)
{
  for (const ElementKind element : with_modes)
    for (const unsigned int refinements : {1u, 2u, 3u})
      {
        const auto [ratio, error] = effectivity(element, refinements);
        EXPECT_GT(std::sqrt(ratio), 1.) << name_of(element);
        EXPECT_LT(std::sqrt(ratio), 10.) << name_of(element);
        std::cout << name_of(element) << ' ' << refinements << ": effectivity " << std::sqrt(ratio)
                  << ", error " << std::sqrt(error) << '\n';
      }
}
