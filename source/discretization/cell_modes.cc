// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/cell_matrix.h>

#include <Eigen/Cholesky>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** P at a vertex of the reference cell: 1 or -1. */
    double at_vertex(const unsigned int polynomial, const unsigned int vertex)
    {
      double sign = 1.;
      for (unsigned int zeros = polynomial & ~vertex; zeros != 0; zeros &= zeros - 1)
        sign = -sign;
      return sign;
    }


    /** Integrals over the reference cell, by polynomial. */
    template <int dim>
    struct Moments
    {
      static constexpr unsigned int n = 1u << dim; ///< polynomials, the constant one included

      std::array<std::array<Tensor<1, dim>, n>, n> of_gradients{}; ///< int P grad phi_a
      std::array<std::array<double, n>, n>         of_products{};  ///< int P Q / j

      explicit Moments(const FEValues<dim> &values)
      {
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const double          weight = values.get_quadrature().weight(q);
            const double          scale  = weight * weight / values.JxW(q);
            std::array<double, n> P;
            for (unsigned int p = 1; p < n; ++p)
              P[p] = mode_polynomial<dim>(p, values.get_quadrature().point(q));
            for (unsigned int a = 0; a < n; ++a)
              {
                const Tensor<1, dim> gradient = weight * values.shape_grad(a, q);
                for (unsigned int p = 1; p < n; ++p)
                  of_gradients[p][a] += P[p] * gradient;
              }
            for (unsigned int p = 1; p < n; ++p)
              for (unsigned int r = 1; r < n; ++r)
                of_products[p][r] += P[p] * P[r] * scale;
          }
      }
    };


    template <int dim>
    Tensor<2, dim> stress_of_gradient(const Material &material, const Tensor<2, dim> &gradient)
    {
      Tensor<2, dim> stress   = material.mu() * (gradient + transpose(gradient));
      const double   pressure = material.lambda() * trace(gradient);
      for (unsigned int c = 0; c < dim; ++c)
        stress[c][c] += pressure;
      return stress;
    }
  } // namespace


  template <int dim>
  CellModes<dim>::CellModes(const std::vector<StrainMode> &modes,
                            const FEValues<dim>           &values,
                            const Tensor<2, dim>          &cofactors,
                            const Material                &material,
                            CellMatrix<dim>               &cell)
    : modes(&modes)
    , recovery(modes.size() * n_dofs)
  {
    constexpr unsigned int most_modes = dim * dim + (1u << dim);
    using Square   = Eigen::Matrix<double, -1, -1, Eigen::RowMajor, most_modes, most_modes>;
    using Coupling = Eigen::Matrix<double, -1, n_dofs, Eigen::RowMajor, most_modes, n_dofs>;

    const Moments<dim> moments(values);
    const unsigned int n = modes.size();
    const auto        &Z = matrices;
    Square             H(n, n);
    Coupling           L(n, n_dofs);
    for (const StrainMode &mode : modes)
      matrices.push_back(mode_matrix<dim>(mode, cofactors));
    for (unsigned int m = 0; m < n; ++m)
      {
        const unsigned int   P      = modes[m].polynomial;
        const Tensor<2, dim> stress = stress_of_gradient(material, Z[m]);
        for (unsigned int k = 0; k < n; ++k)
          H(m, k) = scalar_product(stress, Z[k]) * moments.of_products[P][modes[k].polynomial];
        for (unsigned int a = 0; a < n_vertices; ++a)
          for (unsigned int c = 0; c < dim; ++c)
            L(m, dim * a + c) = stress[c] * moments.of_gradients[P][a];
      }
    const Eigen::LLT<Square> factor(H);
    factor.matrixL().solveInPlace(L);
    unsigned int pair = 0;
    for (unsigned int a = 0; a < n_vertices; ++a)
      for (unsigned int b = a; b < n_vertices; ++b, ++pair)
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int c = 0; c < dim; ++c)
            cell.stiffness[pair][dim * d + c] -= L.col(dim * a + c).dot(L.col(dim * b + d));
    Eigen::Map<Coupling> T(recovery.data(), n, n_dofs);
    T = -L;
    factor.matrixU().solveInPlace(T);
  }


  template <int dim>
  ModeGradient<dim> CellModes<dim>::gradient(const double *values) const
  {
    ModeGradient<dim> result{};
    if (!any())
      return result;
    // First by polynomial.
    std::array<Tensor<2, dim>, n_vertices> sums;
    const double                          *row = recovery.data();
    auto                                   Z   = matrices.begin();
    for (const StrainMode &mode : *modes)
      {
        double amplitude = 0.;
        for (unsigned int i = 0; i < n_dofs; ++i)
          amplitude += *row++ * values[i];
        sums[mode.polynomial] += amplitude * *Z++;
      }
    // Then by vertex, one reference direction after another: the coefficients of 1 and of
    // 2 xi_k - 1 become the values at xi_k = 0 and 1.
    for (unsigned int k = 1; k < n_vertices; k <<= 1)
      for (unsigned int v = 0; v < n_vertices; ++v)
        if (!(v & k))
          {
            const Tensor<2, dim> mean = sums[v];
            sums[v] -= sums[v | k];
            sums[v | k] += mean;
          }
    for (unsigned int v = 0; v < n_vertices; ++v)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int i = 0; i < dim; ++i)
          result[c][dim * v + i] = sums[v][c][i];
    return result;
  }


  template <int dim>
  void CellModes<dim>::add_forces(const ModeGradient<dim> &stress, double *forces) const
  {
    if (!any())
      return;
    const double *row = recovery.data();
    auto          Z   = matrices.begin();
    for (const StrainMode &mode : *modes)
      {
        double work = 0.;
        for (unsigned int v = 0; v < n_vertices; ++v)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int i = 0; i < dim; ++i)
              work += at_vertex(mode.polynomial, v) * stress[c][dim * v + i] * (*Z)[c][i];
        ++Z;
        for (unsigned int i = 0; i < n_dofs; ++i)
          forces[i] += *row++ * work;
      }
  }


  template class CellModes<2>;
  template class CellModes<3>;
} // namespace signorini
