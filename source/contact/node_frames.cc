// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/node_frames.h>
#include <signorini/surfaces/contact_frame.h>

namespace signorini
{
  template <int dim>
  NodeFrames<dim>::NodeFrames(
    const std::map<unsigned int, Frame>                              &frames,
    const std::vector<unsigned int>                                  &contact_nodes,
    const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &partitioner)
    : mask_values(partitioner)
  {
    // Ghosts learn their frames row by row, and what they are from a flag: 1 prescribed, 2 contact.
    Vector              flags(partitioner);
    std::vector<Vector> rows(dim, flags);
    for (const auto &[node, frame] : frames)
      {
        flags.local_element(dim * node) = 1.;
        for (unsigned int row = 0; row < dim; ++row)
          for (unsigned int c = 0; c < dim; ++c)
            rows[row].local_element(dim * node + c) = frame[dim * row + c];
      }
    for (const unsigned int node : contact_nodes)
      flags.local_element(dim * node) = 2.;
    flags.update_ghost_values();
    for (Vector &row : rows)
      row.update_ghost_values();
    for (unsigned int node = 0;
         node < (partitioner->locally_owned_size() + partitioner->n_ghost_indices()) / dim;
         ++node)
      if (const double flag = flags.local_element(dim * node); flag > 0.)
        {
          Frame frame;
          for (unsigned int row = 0; row < dim; ++row)
            for (unsigned int c = 0; c < dim; ++c)
              frame[dim * row + c] = rows[row].local_element(dim * node + c);
          special.push_back(node);
          special_frames.push_back(frame);
          if (flag == 2.)
            contact.push_back(node);
        }
  }


  template <int dim>
  HeldNodes<dim> NodeFrames<dim>::held_nodes(const Mask &mask) const
  {
    mask_values.zero_out_ghost_values();
    for (unsigned int i = 0; i < mask.size(); ++i)
      mask_values.local_element(i) = mask[i];
    mask_values.update_ghost_values();
    HeldNodes<dim> result;
    for (unsigned int k = 0; k < special.size(); ++k)
      {
        HeldNode<dim> node{special[k], special_frames[k], {}};
        bool          any = false;
        for (unsigned int c = 0; c < dim; ++c)
          {
            node.held[c] = mask_values.local_element(dim * special[k] + c) > 0.;
            any          = any || node.held[c];
          }
        if (any)
          {
            node.frame = orthonormal_frame<dim>(node.frame, node.held);
            result.push_back(node);
          }
      }
    return result;
  }


  template class NodeFrames<2>;
  template class NodeFrames<3>;
} // namespace signorini
