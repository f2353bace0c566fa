// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/cell_matrix.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    template <int dim>
    void scale(ModeGradient<dim> &gradient, const double factor)
    {
      for (auto &row : gradient)
        for (double &entry : row)
          entry *= factor;
    }
  } // namespace


  template <int dim>
  double ScaledCellMatrix<dim>::mass(const unsigned int a, const unsigned int b) const
  {
    return mass_factor * matrix->mass[CellMatrix<dim>::pair(std::min(a, b), std::max(a, b))];
  }


  template <int dim>
  typename CellMatrix<dim>::Block ScaledCellMatrix<dim>::stiffness(const unsigned int a,
                                                                   const unsigned int b) const
  {
    const auto &block = matrix->stiffness[CellMatrix<dim>::pair(std::min(a, b), std::max(a, b))];
    typename CellMatrix<dim>::Block result;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        result[dim * d + c] = stiffness_factor * (a <= b ? block[dim * d + c] : block[dim * c + d]);
    return result;
  }


  template <int dim>
  ModeGradient<dim> ScaledCellMatrix<dim>::mode_gradient(const double *values) const
  {
    ModeGradient<dim> result = matrix->modes.gradient(values);
    scale<dim>(result, mode_factor);
    return result;
  }


  template <int dim>
  void ScaledCellMatrix<dim>::add_mode_forces(ModeGradient<dim> stress, double *forces) const
  {
    scale<dim>(stress, mode_factor);
    matrix->modes.add_forces(stress, forces);
  }


  template struct ScaledCellMatrix<2>;
  template struct ScaledCellMatrix<3>;
} // namespace signorini
