// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_cell_stress_h
#define signorini_output_cell_stress_h

#include <signorini/discretization/discretization.h>

#include <deal.II/base/symmetric_tensor.h>

namespace signorini
{
  /** All six components of a stress. */
  using Stress = dealii::SymmetricTensor<2, 3>;

  /**
   * Linear elasticity, sigma = lambda tr(eps) I + 2 mu eps. In 2d the strain is plane, so that
   * sigma_zz = lambda tr(eps) = nu (sigma_xx + sigma_yy) comes along.
   */
  template <int dim>
  Stress stress_of(const Material &material, const dealii::SymmetricTensor<2, dim> &strain);

  /** sqrt(3/2) times the norm of the deviator. */
  double von_mises(const Stress &stress);

  /** By active cell of this process. */
  template <int dim>
  using MeanStrains = std::vector<dealii::SymmetricTensor<2, dim>>;

  /**
   * The mean strain of each locally owned cell: that of its displacement, because strain modes have
   * no mean value (see StrainMode). Zero for other cells.
   * @param displacement with ghosts and hanging nodes, see
   *                     Discretization::interpolate_hanging_nodes()
   */
  template <int dim>
  MeanStrains<dim> mean_strains(const Discretization<dim> &discretization,
                                const Vector              &displacement);

  /** The mean stress of each locally owned cell, as the law is linear that of its mean strain. */
  template <int dim>
  std::vector<Stress> cell_stress(const Discretization<dim> &discretization,
                                  const MeanStrains<dim>    &strains);
} // namespace signorini

#endif
