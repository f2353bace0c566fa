// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/cell_stress.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  Stress stress_of(const Material &material, const SymmetricTensor<2, dim> &strain)
  {
    Stress stress = material.lambda() * trace(strain) * unit_symmetric_tensor<3>();
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        stress[i][j] += 2. * material.mu() * strain[i][j];
    return stress;
  }


  double von_mises(const Stress &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }


  template <int dim>
  MeanStrains<dim> mean_strains(const Discretization<dim> &discretization,
                                const Vector              &displacement)
  {
    MeanStrains<dim> result(discretization.mesh().triangulation().n_active_cells());
    FEValues<dim>    fe_values(discretization.mesh().mapping(),
                            discretization.fe(),
                            QGauss<dim>(discretization.mesh().n_quadrature_points()),
                            update_gradients | update_JxW_values);
    std::vector<SymmetricTensor<2, dim>> strains(fe_values.n_quadrature_points);
    for (const auto &cell : discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          fe_values[FEValuesExtractors::Vector(0)].get_function_symmetric_gradients(displacement,
                                                                                    strains);
          SymmetricTensor<2, dim> integral;
          double                  volume = 0.;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              integral += fe_values.JxW(q) * strains[q];
              volume += fe_values.JxW(q);
            }
          result[cell->active_cell_index()] = integral / volume;
        }
    return result;
  }


  template <int dim>
  std::vector<Stress> cell_stress(const Discretization<dim> &discretization,
                                  const MeanStrains<dim>    &strains)
  {
    std::vector<Stress> result(strains.size());
    for (const auto &cell : discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        result[cell->active_cell_index()] =
          stress_of<dim>(discretization.mesh().bodies()[cell->material_id()].material,
                         strains[cell->active_cell_index()]);
    return result;
  }


#define INSTANTIATE(dim)                                                                           \
  template Stress              stress_of<dim>(const Material &, const SymmetricTensor<2, dim> &);  \
  template MeanStrains<dim>    mean_strains(const Discretization<dim> &, const Vector &);          \
  template std::vector<Stress> cell_stress(const Discretization<dim> &, const MeanStrains<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
