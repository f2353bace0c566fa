// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/free_space.h>
#include <signorini/multigrid/relative_rows.h>
#include <signorini/surfaces/contact_frame.h>

#include <Eigen/LU>

#include <algorithm>

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

    const RelativeRows<dim> rows(coordinates);
    for (const auto &[node, oblique_frame] : coordinates.node_frames())
      {
        const auto frame = orthonormal_frame<dim>(oblique_frame);
        for (unsigned int c = 0; c < dim; ++c)
          {
            Entry entry{node, c, {}};
            for (unsigned int d = 0; d < dim; ++d)
              entry.direction[d] = frame[dim * c + d];
            entry.partners_begin = partners.size();
            for (const auto &[partner, weight] : rows.row(node, c))
              partners.push_back({nodes.local(partner), weight});
            entry.partners_end = partners.size();
            entry.level        = rows.level(node);
            entries.push_back(entry);
          }
      }
    n_levels     = coordinates.coupling().n_levels();
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
    std::stable_sort(relative.begin(), relative.end(), [](const Entry &a, const Entry &b) {
      return a.level < b.level;
    });
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
    auto entry = relative.begin();
    for (unsigned int level = 1; level <= n_levels; ++level)
      {
        ghosts->fetch(displacement);
        for (; entry != relative.end() && entry->level == level; ++entry)
          {
            Number opposite = 0;
            for (unsigned int j = entry->partners_begin; j < entry->partners_end; ++j)
              opposite += dot(partners[j].lanes(), ghosts->value(displacement, partners[j].node));
            const Lanes<Number> n = entry->lanes(), u = value(displacement, entry->node);
            set_value(displacement, entry->node, u - n * (dot(n, u) - opposite));
          }
      }
  }


  template <int dim, typename Number>
  void FreeSpace<dim, Number>::project_force(LevelVector<Number> &force) const
  {
    auto entry = relative.rbegin();
    for (unsigned int level = any_partners ? n_levels : 0; level > 0; --level)
      {
        ghosts->template clear<Number>();
        for (; entry != relative.rend() && entry->level == level; ++entry)
          {
            const Lanes<Number> n = entry->lanes(), f = value(force, entry->node);
            const Number        held = dot(n, f);
            set_value(force, entry->node, f - n * held);
            for (unsigned int j = entry->partners_begin; j < entry->partners_end; ++j)
              ghosts->add(force, partners[j].node, partners[j].lanes() * held);
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
              weights += partners[j].weight.norm();
            for (unsigned int j = entry.partners_begin; j < entry.partners_end; ++j)
              {
                const Eigen::Matrix<double, dim, 1> a(partners[j].weight.begin_raw());
                if (const double size = a.norm(); size > 0.)
                  carried.try_emplace(partners[j].node, Block::Zero()).first->second +=
                    weights * stiffness / size * a * a.transpose();
              }
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
