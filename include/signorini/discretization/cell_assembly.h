// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_cell_assembly_h
#define signorini_discretization_cell_assembly_h

#include <signorini/discretization/cell_couplings.h>
#include <signorini/discretization/cell_matrices.h>

namespace signorini
{
  /** Adds matrices of cells to the upper triangle of a sum. */
  template <int dim>
  class CellAssembly
  {
  public:
    /** @param sum with the pattern of the couplings, and filled with zeros */
    CellAssembly(const CellCouplings<dim> &couplings, ElasticMatrices<dim> &sum)
      : couplings(couplings)
      , sum(sum)
    {
    }

    /** @param index of the cell among those of the couplings */
    void add(unsigned int index, const ScaledCellMatrix<dim> &cell);

  private:
    static constexpr unsigned int n_vertices = CellMatrix<dim>::n_vertices;

    const CellCouplings<dim> &couplings;
    ElasticMatrices<dim>     &sum;

    // Of the cell with hanging nodes that is being added.
    std::vector<unsigned int> nodes; ///< that it couples, ascending
    std::vector<unsigned int>
      places; ///< in the sum, of the couplings of `nodes`, row by row; of the upper triangle
    std::array<std::vector<std::pair<unsigned int, double>>, n_vertices>
      parts; ///< of its vertices, by place in `nodes`

    void add_plain(const unsigned int *vertices, const ScaledCellMatrix<dim> &cell);
    void add_resolved(const unsigned int *vertices, const ScaledCellMatrix<dim> &cell);
    void find_places(const unsigned int *vertices);
  };
} // namespace signorini

#endif
