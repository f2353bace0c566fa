// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/cell_strain.h>

namespace signorini
{
  namespace
  {
    template <int dim>
    unsigned int unordered_pair(const unsigned int a, const unsigned int b)
    {
      return PointTable<dim>::pair(std::min(a, b), std::max(a, b));
    }
  } // namespace


  template <int dim>
  FourVectors<dim> CellStrain<dim>::divergence_of_stress(const PointTable<dim>   &polynomials,
                                                         const PointTable<dim>   &map_polynomials,
                                                         const FourMatrices<dim> &K,
                                                         const FourNumbers       &volume) const
  {
    const FourHessians<dim> of_map = map_polynomials.second_derivatives(numbers(points));
    FourVectors<dim>        result = of_displacement(polynomials, of_map, K);
    if (has_modes)
      {
        const FourVectors<dim> more = of_modes(polynomials, of_map, K, volume);
        for (unsigned int c = 0; c < dim; ++c)
          result[c] += more[c];
      }
    return result;
  }


  /**
   * (lambda + mu) grad div u + mu Laplace u; bilinear functions have mixed second derivatives. By x
   * they are
   *
   *   d2 u_c/(dx_i dx_j) = sum_ab K_ai K_bj W_c,ab,
   *   W_c,ab = d2 u_c/(dxi_a dxi_b) - sum_k du_c/dx_k d2 x_k/(dxi_a dxi_b).
   */
  template <int dim>
  FourVectors<dim> CellStrain<dim>::of_displacement(const PointTable<dim>   &polynomials,
                                                    const FourHessians<dim> &of_map,
                                                    const FourMatrices<dim> &K) const
  {
    const auto subtrahend = product(product(polynomials.gradients(values.data()), K), of_map);
    auto       W          = polynomials.second_derivatives(values.data());
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int p = 0; p < PointTable<dim>::n_pairs; ++p)
        W[c][p] -= subtrahend[c][p];

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
                along_a += K[b][c] * W[c][unordered_pair<dim>(a, b)];
                result[c] += material.mu() * metric * W[c][unordered_pair<dim>(a, b)];
              }
          }
        for (unsigned int i = 0; i < dim; ++i)
          result[i] += (material.lambda() + material.mu()) * K[a][i] * along_a;
      }
    return result;
  }


  /**
   * Of the gradient G/j of the modes, G multilinear on the reference cell:
   *
   *   d(G/j)/dx_i = sum_a K_ai (dG/dxi_a - G sum_bk K_bk d2 x_k/(dxi_a dxi_b)) / j.
   */
  template <int dim>
  FourVectors<dim> CellStrain<dim>::of_modes(const PointTable<dim>   &polynomials,
                                             const FourHessians<dim> &of_map,
                                             const FourMatrices<dim> &K,
                                             const FourNumbers       &volume) const
  {
    FourVectors<dim> growth{}; // of the volume element, (dj/dxi_a)/j
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        for (unsigned int k = 0; k < dim; ++k)
          growth[a] += K[b][k] * of_map[k][unordered_pair<dim>(a, b)];

    std::array<FourMatrices<dim>, dim> by_xi; // entry [c][d][a]: d(G_cd/j)/dxi_a
    for (unsigned int c = 0; c < dim; ++c)
      {
        const FourVectors<dim> G = polynomials.values(modes[c].data());
        by_xi[c]                 = polynomials.gradients(modes[c].data());
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int a = 0; a < dim; ++a)
            by_xi[c][d][a] = (by_xi[c][d][a] - G[d] * growth[a]) / volume;
      }

    FourVectors<dim> result{};
    for (unsigned int a = 0; a < dim; ++a)
      {
        FourNumbers trace{};
        for (unsigned int d = 0; d < dim; ++d)
          trace += by_xi[d][d][a];
        for (unsigned int c = 0; c < dim; ++c)
          {
            result[c] += material.lambda() * K[a][c] * trace;
            for (unsigned int d = 0; d < dim; ++d)
              result[c] += material.mu() * K[a][d] * (by_xi[c][d][a] + by_xi[d][c][a]);
          }
      }
    return result;
  }


  template class CellStrain<2>;
  template class CellStrain<3>;
} // namespace signorini
