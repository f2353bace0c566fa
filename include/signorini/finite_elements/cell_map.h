// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_cell_map_h
#define signorini_finite_elements_cell_map_h

#include <signorini/finite_elements/point_table.h>

#include <deal.II/fe/mapping_q.h>

namespace signorini
{
  /** Support points of the map of a cell, one after another. */
  template <int dim>
  std::vector<dealii::Point<dim>>
  support_points(const dealii::MappingQ<dim>                                     &mapping,
                 const typename dealii::Triangulation<dim>::active_cell_iterator &cell)
  {
    // The mapping shows them to those who derive from it.
    struct Access : public dealii::MappingQ<dim>
    {
      static auto function() { return &Access::compute_mapping_support_points; }
    };
    return (mapping.*Access::function())(cell);
  }

  template <int dim>
  const double *numbers(const std::vector<dealii::Point<dim>> &points)
  {
    static_assert(sizeof(dealii::Point<dim>) == dim * sizeof(double),
                  "points are arrays of numbers");
    return &points[0][0];
  }

  /** Cofactors of Jacobians, entry [d][i] = det d xi_d/d x_i. */
  inline FourMatrices<2> cofactors(const FourMatrices<2> &J)
  {
    return {{{{J[1][1], -J[0][1]}}, {{-J[1][0], J[0][0]}}}};
  }

  inline FourMatrices<3> cofactors(const FourMatrices<3> &J)
  {
    FourMatrices<3> result;
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int d1 = (d + 1) % 3, d2 = (d + 2) % 3, i1 = (i + 1) % 3, i2 = (i + 2) % 3;
          result[d][i] = J[i1][d1] * J[i2][d2] - J[i1][d2] * J[i2][d1];
        }
    return result;
  }

  /** Volume element, from a Jacobian and its cofactors. */
  template <int dim>
  FourNumbers determinant(const FourMatrices<dim> &jacobian, const FourMatrices<dim> &cofactors)
  {
    FourNumbers sum = jacobian[0][0] * cofactors[0][0];
    for (unsigned int d = 1; d < dim; ++d)
      sum += jacobian[0][d] * cofactors[d][0];
    return sum;
  }

  /** Product of matrices of any shapes that fit. */
  template <std::size_t rows, std::size_t inner, std::size_t columns>
  std::array<std::array<FourNumbers, columns>, rows>
  product(const std::array<std::array<FourNumbers, inner>, rows>    &a,
          const std::array<std::array<FourNumbers, columns>, inner> &b)
  {
    std::array<std::array<FourNumbers, columns>, rows> result;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        {
          result[i][j] = a[i][0] * b[0][j];
          for (std::size_t k = 1; k < inner; ++k)
            result[i][j] += a[i][k] * b[k][j];
        }
    return result;
  }
} // namespace signorini

#endif
