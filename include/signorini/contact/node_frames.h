// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_node_frames_h
#define signorini_contact_node_frames_h

#include <signorini/linear_algebra/masked_preconditioner.h>
#include <signorini/linear_algebra/node_masks.h>

#include <deal.II/base/partitioner.h>

#include <map>

namespace signorini
{
  /**
   * The frames of the nodes that may ever be held, contact nodes and prescribed ones, as far as a
   * process sees them: its owned nodes and the ghosts of a partitioner. It turns masks of owned
   * entries into held directions of nodes.
   */
  template <int dim>
  class NodeFrames
  {
  public:
    using Frame = std::array<double, dim * dim>;

    /**
     * Collective.
     * @param frames        of owned nodes, row by row
     * @param contact_nodes those of them that are contact nodes
     */
    NodeFrames(const std::map<unsigned int, Frame>                              &frames,
               const std::vector<unsigned int>                                  &contact_nodes,
               const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &partitioner);

    /** Local nodes, ghosts included, that may ever be held. Ascending. */
    const std::vector<unsigned int> &special_nodes() const { return special; }

    /** Local nodes, ghosts included, that are contact nodes. Ascending. */
    const std::vector<unsigned int> &contact_nodes() const { return contact; }

    /**
     * The held directions of special nodes that a mask of owned entries describes. Collective:
     * asks the owners of ghosts.
     */
    HeldNodes<dim> held_nodes(const Mask &mask) const;

  private:
    std::vector<unsigned int> special, contact;
    std::vector<Frame>        special_frames; ///< in the order of `special`
    mutable Vector            mask_values;
  };
} // namespace signorini

#endif
