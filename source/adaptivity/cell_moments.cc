// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/cell_moments.h>

#include <deal.II/base/quadrature_lib.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  CellMoments<dim>::CellMoments(const Discretization<dim> &discretization)
    : scene(discretization.scene)
    , scalar_fe(1)
    , fe_values(discretization.mapping,
                scalar_fe,
                QGauss<dim>(discretization.n_quadrature_points()),
                update_values | update_gradients | update_JxW_values)
  {
  }


  template <int dim>
  typename CellMoments<dim>::Values CellMoments<dim>::of_mass(const Cell &cell, const Values &values)
  {
    fe_values.reinit(cell);
    const double density = scene.bodies[cell->material_id()].material.density;
    Values       moments(values.size(), 0.);
    for (const unsigned int q : fe_values.quadrature_point_indices())
      for (unsigned int c = 0; c < dim; ++c)
        {
          double value = 0.;
          for (unsigned int a = 0; a < fe_values.dofs_per_cell; ++a)
            value += fe_values.shape_value(a, q) * values[dim * a + c];
          for (unsigned int a = 0; a < fe_values.dofs_per_cell; ++a)
            moments[dim * a + c] += density * value * fe_values.shape_value(a, q) * fe_values.JxW(q);
        }
    return moments;
  }


  template <int dim>
  typename CellMoments<dim>::Values CellMoments<dim>::of_stiffness(const Cell &cell, const Values &values)
  {
    fe_values.reinit(cell);
    const Material &material = scene.bodies[cell->material_id()].material;
    Values          moments(values.size(), 0.);
    for (const unsigned int q : fe_values.quadrature_point_indices())
      {
        Tensor<2, dim> gradient;
        for (unsigned int a = 0; a < fe_values.dofs_per_cell; ++a)
          for (unsigned int c = 0; c < dim; ++c)
            gradient[c] += values[dim * a + c] * fe_values.shape_grad(a, q);
        const SymmetricTensor<2, dim> strain = symmetrize(gradient);
        const SymmetricTensor<2, dim> stress =
          material.lambda() * trace(strain) * unit_symmetric_tensor<dim>() + 2. * material.mu() * strain;
        for (unsigned int a = 0; a < fe_values.dofs_per_cell; ++a)
          {
            const Tensor<1, dim> force = stress * fe_values.shape_grad(a, q) * fe_values.JxW(q);
            for (unsigned int c = 0; c < dim; ++c)
              moments[dim * a + c] += force[c];
          }
      }
    return moments;
  }


  template class CellMoments<2>;
  template class CellMoments<3>;
} // namespace signorini
