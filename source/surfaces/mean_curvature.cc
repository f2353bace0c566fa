// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/mean_curvature.h>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  void MeanCurvature<dim>::add(const double          weight,
                               const Point<dim>     &position,
                               const Tensor<1, dim> &unit_normal)
  {
    if (!(weight > 0.))
      return;
    this->weight += weight;
    const Tensor<1, dim> before = position - mean_position;
    mean_position += weight / this->weight * before;
    squares += weight * (before * (position - mean_position));
    normals += weight * unit_normal;
  }


  template <int dim>
  double MeanCurvature<dim>::value(const MPI_Comm communicator) const
  {
    const double total = Utilities::MPI::sum(weight, communicator);
    if (!(total > 0.))
      return 0.;
    const double spread_of_normals =
      1. - (Utilities::MPI::sum(normals, communicator) / total).norm_square();
    const Tensor<1, dim> mean_of_all =
      Utilities::MPI::sum(weight * mean_position, communicator) / total;
    const double spread_of_points =
      Utilities::MPI::sum(squares + weight * (mean_position - mean_of_all).norm_square(),
                          communicator)
      / total;
    constexpr double round_off = 1e-12;
    return spread_of_normals > round_off && spread_of_points > 0.
             ? std::sqrt(spread_of_normals / spread_of_points)
             : 0.;
  }


  NormalWeights weights_of_normals(const double slave_curvature, const double master_curvature)
  {
    const double sum = slave_curvature + master_curvature;
    return sum > 0. ? NormalWeights{master_curvature / sum, slave_curvature / sum}
                    : NormalWeights();
  }


  template class MeanCurvature<2>;
  template class MeanCurvature<3>;
} // namespace signorini
