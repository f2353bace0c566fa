// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_parts.h>
#include <signorini/finite_elements/cell_map.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * div sigma = (lambda + mu) grad div u + mu Laplace u at four points; bilinear functions have
     * mixed second derivatives. By x they are, with K = d xi/d x,
     *
     *   d2 u_c/(dx_i dx_j) = sum_ab K_ai K_bj W_c,ab,
     *   W_c,ab = d2 u_c/(dxi_a dxi_b) - sum_k du_c/dx_k d2 x_k/(dxi_a dxi_b).
     */
    template <int dim>
    FourVectors<dim> divergence_of_stress(const PointTable<dim>   &polynomials,
                                          const PointTable<dim>   &map_polynomials,
                                          const FourMatrices<dim> &K,
                                          const Material          &material,
                                          const double            *displacement,
                                          const double            *support_points)
    {
      using Table         = PointTable<dim>;
      const auto gradient = product(polynomials.gradients(displacement), K);
      const auto of_map   = product(gradient, map_polynomials.second_derivatives(support_points));
      auto       W        = polynomials.second_derivatives(displacement);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int p = 0; p < Table::n_pairs; ++p)
          W[c][p] -= of_map[c][p];

      FourVectors<dim> result{};
      for (unsigned int a = 0; a < dim; ++a)
        {
          FourNumbers along_a{}; // derivative of div u by xi_a, but for the change of K
          for (unsigned int b = 0; b < dim; ++b)
            {
              FourNumbers metric = K[a][0] * K[b][0];
              for (unsigned int j = 1; j < dim; ++j)
                metric += K[a][j] * K[b][j];
              for (unsigned int c = 0; c < dim; ++c)
                {
                  along_a += K[b][c] * W[c][Table::pair(std::min(a, b), std::max(a, b))];
                  result[c] +=
                    material.mu() * metric * W[c][Table::pair(std::min(a, b), std::max(a, b))];
                }
            }
          for (unsigned int i = 0; i < dim; ++i)
            result[i] += (material.lambda() + material.mu()) * K[a][i] * along_a;
        }
      return result;
    }
  } // namespace


  template <int dim>
  void add_interior_residual(const CellNeighbors<dim> &mesh,
                             const Vector             &displacement,
                             const Vector             &specific_force,
                             const ResidualWeights    &weights,
                             dealii::Vector<double>   &squares)
  {
    const auto &mapping = mesh.discretization.mesh().mapping();
    const auto &tables  = GaussTables<dim>::of_degree(1).interior;
    const auto &of_map  = GaussTables<dim>::of_degree(mapping.get_degree()).interior;
    std::array<double, dim *(1 << dim)> values, forces;
    for (const LocalCell<dim> &cell : mesh.cells)
      if (cell.owned)
        {
          mesh.gather(cell, displacement, values.data());
          mesh.gather(cell, specific_force, forces.data());
          const auto      points   = support_points(mapping, cell.cell);
          const Material &material = mesh.discretization.mesh().bodies()[cell.body].material;
          FourNumbers     square{};
          for (std::size_t t = 0; t < tables.size(); ++t)
            {
              const auto        jacobian = of_map[t].gradients(numbers(points));
              auto              K        = cofactors(jacobian);
              const FourNumbers volume   = determinant<dim>(jacobian, K);
              for (auto &row : K)
                for (auto &entry : row)
                  entry /= volume;
              FourVectors<dim> residual = divergence_of_stress<dim>(
                tables[t], of_map[t], K, material, values.data(), numbers(points));
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


  template void add_interior_residual(const CellNeighbors<2> &,
                                      const Vector &,
                                      const Vector &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
  template void add_interior_residual(const CellNeighbors<3> &,
                                      const Vector &,
                                      const Vector &,
                                      const ResidualWeights &,
                                      dealii::Vector<double> &);
} // namespace signorini
