// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_cell_matrix_h
#define signorini_discretization_cell_matrix_h

#include <signorini/discretization/cell_modes.h>
#include <signorini/linear_algebra/elastic_matrices.h>

namespace signorini
{
  /**
   * Consistent mass and stiffness of one cell: of the pairs (a, b) of its vertices with a <= b,
   * row by row. Strain modes are eliminated.
   */
  template <int dim>
  struct CellMatrix
  {
    using Block                              = typename ElasticMatrices<dim>::Block;
    static constexpr unsigned int n_vertices = 1u << dim;
    static constexpr unsigned int n_pairs    = n_vertices * (n_vertices + 1) / 2;

    std::array<double, n_pairs> mass;
    std::array<Block, n_pairs>
                   stiffness; ///< rows are components at a, columns those at b; column by column
    CellModes<dim> modes;

    /** Place of the pair (a, b), a <= b. */
    static constexpr unsigned int pair(const unsigned int a, const unsigned int b)
    {
      return a * n_vertices - a * (a + 1) / 2 + b;
    }
  };


  /**
   * Mass, stiffness and strain modes of a cell, as multiples of those of a congruent one. Valid
   * until the next matrix is asked for.
   */
  template <int dim>
  struct ScaledCellMatrix
  {
    const CellMatrix<dim> *matrix;
    double                 mass_factor, stiffness_factor, mode_factor;

    /** Of any two vertices. */
    double mass(unsigned int a, unsigned int b) const;
    /** Of any two vertices; column by column. */
    typename CellMatrix<dim>::Block stiffness(unsigned int a, unsigned int b) const;

    /** Whether the strain is another one than that of the displacement. */
    bool has_modes() const { return matrix->modes.any(); }
    /** See CellModes. */
    ModeGradient<dim> mode_gradient(const double *values) const;
    /** See CellModes. */
    void add_mode_forces(ModeGradient<dim> stress, double *forces) const;
  };
} // namespace signorini

#endif
