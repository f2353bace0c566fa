// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/point_table.h>

#include <deal.II/base/quadrature_lib.h>

#include <map>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * sum_k numbers[k] weights[k], for each component of the numbers and each entry of the
     * weights.
     */
    template <int dim, std::size_t n>
    inline std::array<std::array<FourNumbers, n>, dim>
    combine(const std::vector<std::array<FourNumbers, n>> &weights, const double *numbers)
    {
      std::array<std::array<FourNumbers, n>, dim> sum{};
      for (const auto &weight : weights)
        {
          for (unsigned int c = 0; c < dim; ++c)
            for (std::size_t i = 0; i < n; ++i)
              sum[c][i] += weight[i] * numbers[c];
          numbers += dim;
        }
      return sum;
    }

    /** The Gauss points of the part of a face at one of its vertices, or of the whole face. */
    template <int dim>
    typename PointTable<dim>::Points points_of_face(const unsigned int face, const int subface)
    {
      const QGauss<dim - 1>            gauss(2);
      typename PointTable<dim>::Points points;
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          const Point<dim - 1> &on_face = gauss.point(q % gauss.size());
          for (unsigned int d = 0, tangent = 0; d < dim; ++d)
            if (d == face / 2)
              points[q][d] = face % 2;
            else
              {
                const double x = on_face[tangent];
                points[q][d]   = subface < 0 ? x : 0.5 * ((subface >> tangent & 1) + x);
                ++tangent;
              }
        }
      return points;
    }
  } // namespace


  template <int dim>
  PointTable<dim>::PointTable(const FE_Q<dim> &polynomials, const Points &points)
    : zeroth(polynomials.n_dofs_per_cell())
    , first(polynomials.n_dofs_per_cell())
    , second(polynomials.n_dofs_per_cell())
  {
    for (unsigned int k = 0; k < zeroth.size(); ++k)
      for (unsigned int q = 0; q < n_points; ++q)
        {
          zeroth[k][0][q]     = polynomials.shape_value(k, points[q]);
          const auto gradient = polynomials.shape_grad(k, points[q]);
          const auto hessian  = polynomials.shape_grad_grad(k, points[q]);
          for (unsigned int a = 0; a < dim; ++a)
            {
              first[k][a][q] = gradient[a];
              for (unsigned int b = a; b < dim; ++b)
                second[k][pair(a, b)][q] = hessian[a][b];
            }
        }
  }


  template <int dim>
  FourVectors<dim> PointTable<dim>::values(const double *numbers) const
  {
    const auto       sums = combine<dim>(zeroth, numbers);
    FourVectors<dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = sums[c][0];
    return result;
  }


  template <int dim>
  FourMatrices<dim> PointTable<dim>::gradients(const double *numbers) const
  {
    return combine<dim>(first, numbers);
  }


  template <int dim>
  std::array<std::array<FourNumbers, PointTable<dim>::n_pairs>, dim>
  PointTable<dim>::second_derivatives(const double *numbers) const
  {
    return combine<dim>(second, numbers);
  }


  template <int dim>
  GaussTables<dim>::GaussTables(const unsigned int degree)
  {
    const FE_Q<dim> polynomials(degree);
    for (unsigned int face = 0; face < n_faces; ++face)
      {
        faces.emplace_back(polynomials, points_of_face<dim>(face, -1));
        for (unsigned int subface = 0; subface < n_subfaces; ++subface)
          subfaces.emplace_back(polynomials, points_of_face<dim>(face, subface));
      }
    for (unsigned int v = 0; v < n_face_points; ++v)
      {
        const QGauss<dim - 1> gauss(2);
        for (unsigned int q = 0; q < PointTable<dim>::n_points; ++q)
          vertex_functions[v][q] = FE_Q<dim - 1>(1).shape_value(v, gauss.point(q % gauss.size()));
      }
    const QGauss<dim> gauss(2);
    for (unsigned int first = 0; first < gauss.size(); first += PointTable<dim>::n_points)
      {
        typename PointTable<dim>::Points points;
        for (unsigned int q = 0; q < points.size(); ++q)
          points[q] = gauss.point(first + q);
        interior.emplace_back(polynomials, points);
      }
  }


  template <int dim>
  const GaussTables<dim> &GaussTables<dim>::of_degree(const unsigned int degree)
  {
    static std::map<unsigned int, GaussTables> tables;
    return tables.try_emplace(degree, degree).first->second;
  }


  template class PointTable<2>;
  template class PointTable<3>;
  template struct GaussTables<2>;
  template struct GaussTables<3>;
} // namespace signorini
