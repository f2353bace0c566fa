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
} // namespace signorini

#endif
