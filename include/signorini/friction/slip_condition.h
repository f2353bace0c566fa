// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_friction_slip_condition_h
#define signorini_friction_slip_condition_h

#include <signorini/friction/friction_law.h>

#include <Eigen/Core>

namespace signorini
{
  /**
   * The tangential components of a node: two in 3d; in 2d, or where one is prescribed, the second
   * is zero.
   */
  using TangentVector = Eigen::Vector2d;
  using TangentMatrix = Eigen::Matrix2d;

  /**
   * What the solver knows of a closed contact node. Forces count as in K w + force = b:
   * compression > 0, friction along the slip.
   */
  struct NodeForces
  {
    double        normal     = 0.;                    ///< n
    TangentVector tangential = TangentVector::Zero(); ///< t
    TangentVector slip       = TangentVector::Zero(); ///< s
  };

  /**
   * Coulomb's law as one equation without inequality, C(s, t, n) = max(b, |y|) t - b y = 0 with y =
   * t + c s and the bound b(n) of the law (Hueeber, Stadler and Wohlmuth, SIAM J. Sci. Comput. 30
   * (2008) 572-596). A node sticks if |y| <= b. A slipping one obeys, to first order,
   *
   *   t_new = force + stiffness (s_new - s) + coupling (n_new - n).
   *
   * The derivative is modified where the force does not yet point along y, so that the node
   * equation can always be solved for t_new; at a solution it is the exact one.
   */
  struct SlipCondition
  {
    TangentVector force;
    TangentMatrix stiffness;
    TangentVector coupling;
  };

  /** What is already known of a node about which sticks() decides. */
  struct SlipHistory
  {
    bool has_stuck   = false; ///< in the solution that is judged
    bool has_slipped = false; ///< there, by the linearised law
    bool stops_first = true;  ///< if it slips against its force
  };

  /**
   * Whether |y| <= b, or whether the node slips against its force. What has stuck or slipped goes
   * on as long as this is right but for what solvers leave open: a body at rest, whose friction has
   * carried it there, is at the bound all over, and round-off would choose.
   * @param stiffness c > 0, any; of the size of K
   */
  bool sticks(const FrictionLaw &law,
              const NodeForces  &node,
              double             stiffness,
              const SlipHistory &history = {});

  /**
   * Whether a node slips so far against its force that the same force the other way would not bring
   * it back, if it were alone: it may go on slipping, with its force turned round.
   */
  bool may_turn_round(const FrictionLaw &law, const NodeForces &node, double stiffness);

  /**
   * The condition of a slipping node. Where the node would rather stick, only the direction of y
   * counts.
   * @param n_tangents with one, the direction of slip cannot turn
   */
  SlipCondition linearise_slip(const FrictionLaw &law,
                               const NodeForces  &node,
                               double             stiffness,
                               unsigned int       n_tangents);

  /**
   * The friction of a slipping node: of the size of the bound, in the direction of y as the solver
   * takes it, which is that of a long slip, and that of t where slip is too small to have one.
   * @param stiffness c > 0, of the size of K
   */
  TangentVector slip_force(const FrictionLaw &law, const NodeForces &node, double stiffness);
} // namespace signorini

#endif
