// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// On curved cells with hanging nodes the parts of the residual estimate agree, to round-off, with
// the same integrals by deal.II's FEValues and FEFaceValues, which set up maps and derivatives in
// their own way.

#include "../contact/contact_scene.h"

#include <signorini/adaptivity/residual_estimate.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

using namespace signorini;
using namespace signorini::tests;

namespace
{
  /** The squared interior residual of each cell. */
  template <int dim>
  void expect_interior_residual(const CellNeighbors<dim> &mesh,
                                const Material           &material,
                                const Vector             &u)
  {
    const auto            &discretization = mesh.discretization;
    dealii::Vector<double> interior(discretization.mesh().triangulation().n_active_cells());
    add_interior_residual(StressVectors<dim>(mesh, u), u, ResidualWeights{}, interior);

    const dealii::FEValuesExtractors::Vector vector(0);
    dealii::FEValues<dim>                    values(discretization.mesh().mapping(),
                                 discretization.fe(),
                                 dealii::QGauss<dim>(2),
                                 dealii::update_values | dealii::update_hessians
                                   | dealii::update_JxW_values);
    std::vector<dealii::Tensor<3, dim>>      hessians(values.n_quadrature_points);
    std::vector<dealii::Tensor<1, dim>>      forces(values.n_quadrature_points);
    const double                             lambda = material.lambda(), mu = material.mu();
    for (const auto &[cell, nodes, index, body, owned] : mesh.cells)
      {
        if (!owned)
          continue;
        values.reinit(cell);
        values[vector].get_function_hessians(u, hessians);
        values[vector].get_function_values(u, forces);
        double square = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          {
            dealii::Tensor<1, dim> residual = material.density * forces[q];
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                residual[c] += (lambda + mu) * hessians[q][d][c][d] + mu * hessians[q][c][d][d];
            square += residual.norm_square() * values.JxW(q);
          }
        square *= ResidualWeights{}.cell(material, cell->diameter() / std::sqrt(double(dim)));
        EXPECT_NEAR(interior(index), square, 1e-10 * square);
      }
  }

  /** The integral of the squared stress vector over each face. */
  template <int dim>
  void
  expect_stress_vectors(const CellNeighbors<dim> &mesh, const Material &material, const Vector &u)
  {
    const auto                                  &discretization = mesh.discretization;
    const dealii::FEValuesExtractors::Vector     vector(0);
    dealii::FEFaceValues<dim>                    faces(discretization.mesh().mapping(),
                                    discretization.fe(),
                                    dealii::QGauss<dim - 1>(2),
                                    dealii::update_gradients | dealii::update_JxW_values
                                      | dealii::update_normal_vectors);
    std::vector<dealii::SymmetricTensor<2, dim>> strains(faces.n_quadrature_points);
    const StressVectors<dim>                     stress(mesh, u);
    const double                                 lambda = material.lambda(), mu = material.mu();
    for (unsigned int i = 0; i < mesh.cells.size(); ++i)
      for (const unsigned int face : mesh.cells[i].cell->face_indices())
        {
          if (!mesh.cells[i].owned)
            continue;
          faces.reinit(mesh.cells[i].cell, face);
          faces[vector].get_function_symmetric_gradients(u, strains);
          double expected = 0., found = 0.;
          for (const unsigned int q : faces.quadrature_point_indices())
            {
              const dealii::Tensor<1, dim> n = faces.normal_vector(q);
              expected +=
                (lambda * trace(strains[q]) * n + 2. * mu * (strains[q] * n)).norm_square()
                * faces.JxW(q);
            }
          const FaceStress<dim> &there = stress.of_face(i, face);
          for (unsigned int q = 0; q < PointTable<dim>::n_points; ++q)
            for (unsigned int c = 0; c < dim; ++c)
              found += there.vector[c][q] * there.vector[c][q] * there.area[q];
          EXPECT_NEAR(found, expected, 1e-10 * expected);
        }
  }

  template <int dim>
  void expect_agreement(const std::array<std::string, dim> &expressions)
  {
    BodyDescription<dim> body = ball<dim>(1);
    body.element              = ElementKind::standard; // the other ones: strain_modes.cc
    body.local_refinements    = 1;
    body.refine_where         = "x - 0.2";
    Scene<dim> scene          = scene_of<dim>({body});
    scene.mapping             = CellGeometry::curved;
    const Assembled<dim>     problem(scene);
    const auto              &discretization = problem.discretization;
    const CellNeighbors<dim> mesh(discretization);
    const Vector             u =
      discretization.interpolate_hanging_nodes(field<dim>(discretization, expressions));
    expect_interior_residual(mesh, body.material, u);
    expect_stress_vectors(mesh, body.material, u);
  }
} // namespace

TEST(CurvedCells, AgreeWithFEValues)
{
  expect_agreement<2>({{"x*y + y*y", "x*x - 3*y"}});
  expect_agreement<3>({{"x*y + z*z", "x*x - 3*y", "y*z - x"}});
}
