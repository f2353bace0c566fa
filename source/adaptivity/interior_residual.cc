// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_parts.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  void add_interior_residual(const StressVectors<dim> &stress,
                             const Vector             &specific_force,
                             const ResidualWeights    &weights,
                             dealii::Vector<double>   &squares)
  {
    const auto &mesh    = stress.mesh;
    const auto &mapping = mesh.discretization.mesh().mapping();
    const auto &tables  = GaussTables<dim>::of_degree(1).interior;
    const auto &of_map  = GaussTables<dim>::of_degree(mapping.get_degree()).interior;
    std::array<double, dim *(1 << dim)> forces;
    for (unsigned int number = 0; number < mesh.cells.size(); ++number)
      if (const LocalCell<dim> &cell = mesh.cells[number]; cell.owned)
        {
          mesh.gather(cell, specific_force, forces.data());
          const CellStrain<dim> &strain   = stress.strain(number);
          const Material        &material = strain.material;
          FourNumbers            square{};
          for (std::size_t t = 0; t < tables.size(); ++t)
            {
              const auto        jacobian = strain.jacobian(of_map[t]);
              auto              K        = cofactors(jacobian);
              const FourNumbers volume   = determinant<dim>(jacobian, K);
              for (auto &row : K)
                for (auto &entry : row)
                  entry /= volume;
              FourVectors<dim> residual =
                strain.divergence_of_stress(tables[t], of_map[t], K, volume);
              const FourVectors<dim> force = tables[t].values(forces.data());
              for (unsigned int c = 0; c < dim; ++c)
                {
                  residual[c] += material.density * force[c];
                  square += residual[c] * residual[c] * volume;
                }
            }
          const double weight =
            weights.cell(material, cell.cell->diameter() / std::sqrt(double(dim))) / (1 << dim);
          squares(cell.index) += weight * (square[0] + square[1] + square[2] + square[3]);
        }
  }


  template void add_interior_residual(const StressVectors<2> &,
                                      const Vector &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
  template void add_interior_residual(const StressVectors<3> &,
                                      const Vector &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
} // namespace signorini
