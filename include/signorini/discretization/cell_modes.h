// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_cell_modes_h
#define signorini_discretization_cell_modes_h

#include <signorini/discretization/strain_modes.h>
#include <signorini/model/body_description.h>

#include <deal.II/fe/fe_values.h>

namespace signorini
{
  template <int dim>
  struct CellMatrix;

  /**
   * The strain modes of a cell, eliminated. Their amplitudes minimise the elastic energy of the
   * cell for given displacements at the vertices,
   *
   *   alpha = T u,    T = -H^-1 L,    stiffness K - L'H^-1 L,
   *
   * with H = int Z_m:C:Z_n P_m P_n/j dxi and L = int P_m Z_m:C:grad dxi @cite simo_rifai_1990. With
   * T the strain of the cell is a linear function of the displacements again, and the condensed
   * stiffness is the integral of C:strain:strain.
   */
  template <int dim>
  class CellModes
  {
  public:
    static constexpr unsigned int n_vertices = 1u << dim;
    static constexpr unsigned int n_dofs     = dim * n_vertices;

    /** Of a standard element. */
    CellModes() = default;

    /**
     * Eliminates the modes from a stiffness.
     * @param values    gradients and JxW at the quadrature points of the cell
     * @param cofactors see mode_matrix()
     * @param cell      its stiffness is that of the displacements alone before, and the condensed
     *                  one after
     */
    CellModes(const std::vector<StrainMode> &modes,
              const dealii::FEValues<dim>   &values,
              const dealii::Tensor<2, dim>  &cofactors,
              const Material                &material,
              CellMatrix<dim>               &cell);

    bool any() const { return modes != nullptr; }

    /** What they add to the gradient of a displacement with dim values per vertex. */
    ModeGradient<dim> gradient(const double *values) const;

    /**
     * The transposed of gradient(): what a stress adds to the nodal forces through the modes.
     * @param stress entry [c][dim v + i]: int sigma_ci phi_v dxi, over the reference cell
     * @param forces dim per vertex
     */
    void add_forces(const ModeGradient<dim> &stress, double *forces) const;

  private:
    const std::vector<StrainMode>      *modes = nullptr;
    std::vector<dealii::Tensor<2, dim>> matrices; ///< Z, see mode_matrix()
    std::vector<double>                 recovery; ///< T, row by row
  };
} // namespace signorini

#endif
