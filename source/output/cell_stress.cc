// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/cell_stress.h>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  Stress stress_of(const Material &material, const SymmetricTensor<2, dim> &strain)
  {
    Stress stress = material.lambda() * trace(strain) * unit_symmetric_tensor<3>();
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        stress[i][j] += 2. * material.mu() * strain[i][j];
    return stress;
  }


  double von_mises(const Stress &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }


  template Stress stress_of<2>(const Material &, const SymmetricTensor<2, 2> &);
  template Stress stress_of<3>(const Material &, const SymmetricTensor<2, 3> &);
} // namespace signorini
