// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/variational_inequality/tresca_friction.h>

namespace signorini
{
  NodeForces TrescaFriction::forces(const std::size_t k) const
  {
    return node_forces(problem.friction[k], problem.bounded_entries[k], true, point, residual);
  }


  bool TrescaFriction::rests(const std::size_t k) const
  {
    const NodeForces node = forces(k);
    return node.slip.norm() == 0. && node.tangential.norm() <= bounds[k] * (1. + round_off);
  }


  SlipCondition TrescaFriction::condition(const std::size_t k) const
  {
    const NodeForces    node      = forces(k);
    const double        size      = node.slip.norm();
    const TangentVector along     = size > 0. ? node.slip : node.tangential;
    const TangentVector unit      = along / along.norm();
    TangentMatrix       curvature = TangentMatrix::Zero();
    if (size > 0. && problem.friction[k].entries.size() > 1)
      curvature = bounds[k] / size * (TangentMatrix::Identity() - unit * unit.transpose());
    return {bounds[k] * unit, curvature, TangentVector::Zero()};
  }


  void
  TrescaFriction::set_slip(Vector &other, const std::size_t k, const TangentVector &value) const
  {
    const FrictionNode &node = problem.friction[k];
    for (unsigned int j = 0; j < node.entries.size(); ++j)
      other.local_element(node.entries[j]) = value[j] - node.past[j];
  }


  TangentVector TrescaFriction::force(const std::size_t k) const
  {
    const NodeForces    node  = forces(k);
    const TangentVector along = node.slip.norm() > 0. ? node.slip : node.tangential;
    const double        size  = along.norm();
    if (node.slip.norm() == 0. && size <= bounds[k])
      return node.tangential;
    return bounds[k] / size * along;
  }


  double
  TrescaFriction::change(const std::size_t k, const Vector &direction, const double length) const
  {
    const TangentVector change = tangential_entries(problem.friction[k], direction);
    const TangentVector before = forces(k).slip;
    const double        size = before.norm(), change_size = change.norm();
    if (change_size == 0.)
      return 0.;
    if (size == 0.)
      return bounds[k] * change_size - force(k).dot(change);
    const double after = (before + length * change).norm(), along = before.dot(change);
    if (after == 0.)
      return -bounds[k] * (change_size + along / size);
    // (after / |after| - before / |before|) . change, without cancellation
    return bounds[k] * length / (after * size)
           * (size * change_size * change_size
              - along * (2. * along + length * change_size * change_size) / (size + after));
  }
} // namespace signorini
