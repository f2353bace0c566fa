// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/friction/slip_condition.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/LU>

#include <algorithm>

namespace signorini
{
  bool sticks(const FrictionLaw &law,
              const NodeForces  &node,
              const double       stiffness,
              const SlipHistory &history)
  {
    Assert(stiffness > 0., dealii::ExcMessage("The stiffness of a node is positive."));
    // Beyond the bound by round-off only, the transverse stiffness of slip would be infinite.
    constexpr double round_off = 1e-13;
    // By solvers, of the force of a node, which is small beside those that their tolerance is of.
    constexpr double left_open = 1e-9;
    const double     bound     = law.bound(node.normal);
    const double     size      = (node.tangential + stiffness * node.slip).norm();
    if (history.has_slipped && stiffness * node.slip.norm() <= left_open * bound)
      return size < bound * (1. - left_open);
    // A node that slips against its force stops first, however far it went: turned round at once,
    // it may go to and fro for ever.
    return bound > 0.
           && ((history.stops_first && node.tangential.dot(node.slip) < 0.)
               || size <= bound * (1. + (history.has_stuck ? left_open : round_off)));
  }


  bool may_turn_round(const FrictionLaw &law, const NodeForces &node, const double stiffness)
  {
    // The force changes by 2 b, the slip of a node by 2 b/c, and that of neighbours which do the
    // same by more.
    constexpr double far = 10.;
    return node.tangential.dot(node.slip) < 0.
           && stiffness * node.slip.norm() > far * law.bound(node.normal);
  }


  SlipCondition linearise_slip(const FrictionLaw &law,
                               const NodeForces  &node,
                               const double       stiffness,
                               const unsigned int n_tangents)
  {
    Assert(stiffness > 0., dealii::ExcMessage("The stiffness of a node is positive."));
    Assert(n_tangents == 1 || n_tangents == 2, dealii::ExcIndexRange(n_tangents, 1, 3));
    const double        bound = law.bound(node.normal);
    const TangentVector y     = node.tangential + stiffness * node.slip;
    const double        size  = y.norm();
    SlipCondition condition{TangentVector::Zero(), TangentMatrix::Zero(), TangentVector::Zero()};
    if (size == 0.)
      return condition;

    const TangentVector direction = y / size;
    condition.force               = bound * direction;
    condition.coupling            = law.slope(node.normal) * direction;
    if (n_tangents == 1 || bound == 0. || size <= bound)
      return condition; // the direction cannot change, or its change is of no use

    const double force = node.tangential.norm(), ratio = bound / size;
    const double cosine  = force > 0. ? node.tangential.dot(y) / (force * size) : 0.;
    const double damping = cosine < 0. ? 1. / (1. - cosine * std::min(force / bound, 1.)) : 1.;
    const TangentMatrix identity = TangentMatrix::Identity();
    const TangentMatrix turning =
      damping * ratio
      * (identity - node.tangential * direction.transpose() / std::max(bound, force));
    const TangentMatrix inverse = (identity - turning).inverse();
    condition.force             = (inverse * (condition.force - turning * node.tangential)).eval();
    condition.coupling          = (inverse * condition.coupling).eval();
    condition.stiffness         = stiffness * inverse * turning;
    return condition;
  }


  TangentVector slip_force(const FrictionLaw &law, const NodeForces &node, const double stiffness)
  {
    Assert(stiffness > 0., dealii::ExcMessage("The stiffness of a node is positive."));
    const TangentVector y    = node.tangential + stiffness * node.slip;
    const double        size = y.norm();
    return size > 0. ? TangentVector(law.bound(node.normal) / size * y) : y;
  }
} // namespace signorini
