// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/contact_frame.h>
#include <signorini/multigrid/free_space.h>

#include <Eigen/LU>

namespace signorini
{
  namespace
  {
    template <typename Four>
    auto dot(const Four a, const Four b)
    {
      const Four products = a * b;
      return products[0] + products[1] + products[2] + products[3];
    }
  } // namespace


  template <int dim, typename Number>
  FreeSpace<dim, Number>::FreeSpace(const ContactCoordinates<dim> &coordinates,
                                    const NodePattern             &pattern)
  {
    const auto &partitioner = *pattern.partitioner;
    LocalNodes  nodes;
    nodes.n_owned     = pattern.n_owned;
    nodes.first_owned = partitioner.local_range().first / dim;
    for (const ContactNode<dim> &node : coordinates.surface_nodes())
      for (const auto &[partner, weight] : node.partners)
        if (!nodes.owns(partner))
          nodes.ghosts.push_back(partner);
    nodes.sort_ghosts();

    std::map<unsigned int, const ContactNode<dim> *> contact_nodes;
    for (const ContactNode<dim> &node : coordinates.surface_nodes())
      contact_nodes[node.node] = &node;
    for (const auto &[node, oblique_frame] : coordinates.node_frames())
      {
        const auto         frame        = orthonormal_frame<dim>(oblique_frame);
        const auto         contact_node = contact_nodes.find(node);
        const unsigned int begin        = partners.size();
        if (contact_node != contact_nodes.end())
          for (const auto &[partner, weight] : contact_node->second->partners)
            partners.push_back({nodes.local(partner), static_cast<Number>(weight)});
        for (unsigned int c = 0; c < dim; ++c)
          {
            entries.push_back({node, c, {}, 0, 0});
            for (unsigned int d = 0; d < dim; ++d)
              entries.back().direction[d] = frame[dim * c + d];
            if (contact_node != contact_nodes.end() && contact_node->second->relative[c])
              {
                entries.back().partners_begin = begin;
                entries.back().partners_end   = partners.size();
              }
          }
      }
    any_partners = coordinates.coupling().any();
    ghosts       = std::make_unique<GhostValues>(nodes, partitioner.get_mpi_communicator());
  }


  template <int dim, typename Number>
  void FreeSpace<dim, Number>::set_mask(const Mask &mask)
  {
    absolute.clear();
    relative.clear();
    for (const Entry &entry : entries)
      if (mask[dim * entry.node + entry.component])
        (entry.is_relative() ? relative : absolute).push_back(entry);
  }


  template <int dim, typename Number>
  void FreeSpace<dim, Number>::project(LevelVector<Number> &displacement) const
  {
    // Partners may be held, too, but not relative to others: they come first.
    for (const Entry &entry : absolute)
      {
        const Lanes<Number> n = entry.lanes(), u = value(displacement, entry.node);
        set_value(displacement, entry.node, u - n * dot(n, u));
      }
    if (!any_partners)
      return;
    ghosts->fetch(displacement);
    for (const Entry &entry : relative)
      {
        Lanes<Number> opposite{};
        for (unsigned int j = entry.partners_begin; j < entry.partners_end; ++j)
          opposite += partners[j].weight * ghosts->value(displacement, partners[j].node);
        const Lanes<Number> n = entry.lanes(), u = value(displacement, entry.node);
        set_value(displacement, entry.node, u - n * dot(n, u - opposite));
      }
  }


  template <int dim, typename Number>
  void FreeSpace<dim, Number>::project_force(LevelVector<Number> &force) const
  {
    if (any_partners)
      {
        ghosts->template clear<Number>();
        for (const Entry &entry : relative)
          {
            const Lanes<Number> n = entry.lanes(), f = value(force, entry.node),
                                held = n * dot(n, f);
            set_value(force, entry.node, f - held);
            for (unsigned int j = entry.partners_begin; j < entry.partners_end; ++j)
              ghosts->add(force, partners[j].node, partners[j].weight * held);
          }
        ghosts->add_to_owners(force);
      }
    for (const Entry &entry : absolute)
      {
        const Lanes<Number> n = entry.lanes(), f = value(force, entry.node);
        set_value(force, entry.node, f - n * dot(n, f));
      }
  }


  template <int dim, typename Number>
  std::vector<typename FreeSpace<dim, Number>::NodeBlock>
  FreeSpace<dim, Number>::changed_inverses(const LevelMatrix<dim, Number> &matrix) const
  {
    NodeBlocks<dim> held, carried;
    for (const auto *list : {&absolute, &relative})
      for (const Entry &entry : *list)
        held.try_emplace(entry.node, Block::Zero()).first->second += entry.projector();
    if (any_partners)
      {
        for (const Entry &entry : relative)
          {
            const double stiffness = (entry.projector() * matrix.diagonal(entry.node)).trace();
            double       weights   = 0.;
            for (unsigned int j = entry.partners_begin; j < entry.partners_end; ++j)
              weights += std::abs(partners[j].weight);
            for (unsigned int j = entry.partners_begin; j < entry.partners_end; ++j)
              carried.try_emplace(partners[j].node, Block::Zero()).first->second +=
                weights * std::abs(partners[j].weight) * stiffness * entry.projector();
          }
        add_to_owners<dim>(carried, *ghosts);
      }
    for (const auto &[node, block] : carried)
      held.try_emplace(node, Block::Zero());

    std::vector<NodeBlock> result;
    for (const auto &[node, products] : held)
      {
        const Block free  = Block::Identity() - products;
        Block       block = matrix.diagonal(node);
        if (const auto found = carried.find(node); found != carried.end())
          block += found->second;
        // The held directions get any positive number, which is taken away again.
        const Block regular = free * block * free + block.trace() / dim * products;
        result.push_back({node, free * regular.inverse() * free});
      }
    return result;
  }


  template class FreeSpace<2, float>;
  template class FreeSpace<2, double>;
  template class FreeSpace<3, float>;
  template class FreeSpace<3, double>;
} // namespace signorini
