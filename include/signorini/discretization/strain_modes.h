// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_strain_modes_h
#define signorini_discretization_strain_modes_h

#include <signorini/model/element_kind.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace signorini
{
  /**
   * A mode of strain that an element has besides its displacement. On a cell with the map x(xi) the
   * strain of the element is the symmetric part of
   *
   *   grad u + 1/j sum_m alpha_m P_m(xi) Z_m,    j = det dx/dxi,
   *
   * where P_m is a product of some of the 2 xi_k - 1, and Z_m a constant matrix of the cell:
   *
   * - incompatible: e_c (x) (j dxi_k/dx at the centre of the cell), with P = 2 xi_k - 1: the
   *   gradient of the displacement (xi_k^2 - xi_k) e_c, its map frozen at the centre
   *   @cite wilson_taylor_doherty_ghaboussi_1973 @cite taylor_beresford_wilson_1976,
   * - isotropic: a multiple of the identity.
   *
   * The integral of P_m over the reference cell is zero, so that a mode does no work with a
   * constant stress: this is the patch test, on cells of any shape, and makes the mean strain of a
   * cell that of its displacement @cite simo_rifai_1990. The amplitudes are lengths. They minimise
   * the elastic energy of the cell, see CellModes.
   */
  struct StrainMode
  {
    static constexpr unsigned int isotropic = 3;

    unsigned int polynomial; ///< P has the factor 2 xi_k - 1 if bit k is set
    unsigned int direction;  ///< k of an incompatible mode, or `isotropic`
    unsigned int component;  ///< c of an incompatible mode
  };

  /** The modes of an element; none for the standard one. */
  template <int dim>
  const std::vector<StrainMode> &strain_modes(ElementKind element);

  /** P at a point of the reference cell. */
  template <int dim>
  double mode_polynomial(const unsigned int polynomial, const dealii::Point<dim> &point)
  {
    double product = 1.;
    for (unsigned int k = 0; k < dim; ++k)
      if (polynomial >> k & 1)
        product *= 2. * point[k] - 1.;
    return product;
  }

  /**
   * Z.
   * @param cofactors j dxi_k/dx_i at the centre of the cell, entry [k][i]
   */
  template <int dim>
  dealii::Tensor<2, dim> mode_matrix(const StrainMode             &mode,
                                     const dealii::Tensor<2, dim> &cofactors);

  /**
   * j times the gradient that the modes of a cell add to that of a displacement. Multilinear on the
   * reference cell, and stored by its values at the vertices: entry [c][dim v + i] belongs to
   * du_c/dx_i at vertex v.
   */
  template <int dim>
  using ModeGradient = std::array<std::array<double, dim *(1u << dim)>, dim>;
} // namespace signorini

#endif
