// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_variational_inequality_frictional_contact_h
#define signorini_variational_inequality_frictional_contact_h

#include <signorini/base/contact_status.h>
#include <signorini/base/types.h>
#include <signorini/friction/slip_condition.h>

#include <vector>

namespace signorini
{
  /**
   * Friction at a bounded entry: the tangential entries of its node and their law. No entries:
   * none.
   */
  struct FrictionNode
  {
    std::vector<unsigned int> entries; ///< at most two
    FrictionLaw               law; ///< of multipliers, that is of forces in the scale of the matrix
    /** Slip that happened before: the slip is past + x_t. */
    TangentVector past = TangentVector::Zero();
    /**
     * The slip that happened before is far longer than any x: the node slips, always in its
     * direction. To stick it would have to go all the way back.
     */
    bool slides = false;
  };

  /** One per bounded entry; empty if there is no friction at all. */
  using Friction = std::vector<FrictionNode>;

  /**
   * The slip and the multipliers of a node. @param residual b - K x @param normal bounded entry of
   * the node, and whether it is closed
   */
  inline NodeForces node_forces(const FrictionNode &node,
                                const unsigned int  normal,
                                const bool          closed,
                                const Vector       &solution,
                                const Vector       &residual)
  {
    NodeForces result{
      closed ? residual.local_element(normal) : 0., TangentVector::Zero(), node.past};
    for (unsigned int j = 0; j < node.entries.size(); ++j)
      {
        result.tangential[j] = residual.local_element(node.entries[j]);
        result.slip[j] += solution.local_element(node.entries[j]);
      }
    return result;
  }
} // namespace signorini

#endif
