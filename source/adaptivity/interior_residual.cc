// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_estimate.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  void add_interior_residual(const Discretization<dim> &discretization,
                             const Vector              &displacement,
                             const Vector              &specific_force,
                             const ResidualWeights     &weights,
                             dealii::Vector<double>    &squares)
  {
    FEValues<dim>                    fe_values(discretization.mapping,
                            discretization.fe,
                            QGauss<dim>(discretization.n_quadrature_points()),
                            update_values | update_hessians | update_JxW_values);
    const FEValuesExtractors::Vector vector(0);
    std::vector<Tensor<3, dim>>      hessians(fe_values.n_quadrature_points);
    std::vector<Tensor<1, dim>>      forces(fe_values.n_quadrature_points);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          fe_values[vector].get_function_hessians(displacement, hessians);
          fe_values[vector].get_function_values(specific_force, forces);
          const Material &material = discretization.scene.bodies[cell->material_id()].material;
          const double    lambda = material.lambda(), mu = material.mu();
          double          square = 0.;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              // div sigma = (lambda + mu) grad div u + mu Laplace u; bilinear functions have mixed second derivatives.
              Tensor<1, dim> residual = material.density * forces[q];
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  residual[i] += (lambda + mu) * hessians[q][j][i][j] + mu * hessians[q][i][j][j];
              square += residual.norm_square() * fe_values.JxW(q);
            }
          squares(cell->active_cell_index()) +=
            weights.cell(material, cell->diameter() / std::sqrt(double(dim))) * square;
        }
  }


  template void add_interior_residual(const Discretization<2> &,
                                      const Vector &,
                                      const Vector &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
  template void add_interior_residual(const Discretization<3> &,
                                      const Vector &,
                                      const Vector &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
} // namespace signorini
