// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/relative_rows.h>
#include <signorini/surfaces/contact_frame.h>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  RelativeRows<dim>::RelativeRows(const ContactCoordinates<dim> &coordinates)
    : coordinates(coordinates)
  {
    const auto &nodes = coordinates.surface_nodes();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      contact_nodes[nodes[k].node].push_back(k);
  }


  template <int dim>
  typename RelativeRows<dim>::Row RelativeRows<dim>::row(const unsigned int node,
                                                         const unsigned int component) const
  {
    const auto of_node = contact_nodes.find(node);
    if (of_node == contact_nodes.end())
      return {};
    std::map<types::global_dof_index, Tensor<1, dim>> sums;
    for (const std::size_t k : of_node->second)
      {
        const ContactNode<dim> &contact_node = coordinates.surface_nodes()[k];
        if (contact_node.partners.empty())
          continue;
        const auto     orthonormal = orthonormal_frame<dim>(contact_node.frame);
        Tensor<1, dim> direction;
        for (unsigned int c = 0; c < dim; ++c)
          direction[c] = orthonormal[dim * component + c];
        for (unsigned int i = 0; i < dim; ++i)
          if (contact_node.relative[i])
            {
              double part = 0.;
              for (unsigned int c = 0; c < dim; ++c)
                part += direction[c] * contact_node.dual_frame()[dim * i + c];
              if (std::abs(part) > 1e-14)
                for (const auto &[partner, weight] : contact_node.partners)
                  sums[partner] += part * weight * contact_node.direction(i);
            }
      }
    return Row(sums.begin(), sums.end());
  }


  template <int dim>
  unsigned int RelativeRows<dim>::level(const unsigned int node) const
  {
    const auto of_node = contact_nodes.find(node);
    return of_node == contact_nodes.end() ? 0
                                          : coordinates.coupling().level(of_node->second.front());
  }


  template class RelativeRows<2>;
  template class RelativeRows<3>;
} // namespace signorini
