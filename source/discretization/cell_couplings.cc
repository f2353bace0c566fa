// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/cell_couplings.h>
#include <signorini/discretization/discretization.h>

#include <numeric>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  CellCouplings<dim>::CellCouplings(const Discretization<dim> &discretization)
  {
    number_nodes(discretization);
    is_resolved.resize(cell_vertices.size() / n_vertices);
    for (unsigned int cell = 0; cell < is_resolved.size(); ++cell)
      is_resolved[cell] = std::any_of(vertices(cell),
                                      vertices(cell) + n_vertices,
                                      [this](const unsigned int node) { return is_hanging(node); });
  }


  template <int dim>
  void CellCouplings<dim>::number_nodes(const Discretization<dim> &discretization)
  {
    const IndexSet &owned = discretization.locally_owned();
    Assert(owned.is_contiguous(), ExcInternalError());
    local_nodes.first_owned = owned.is_empty() ? 0 : owned.nth_index_in_set(0) / dim;
    local_nodes.n_owned     = owned.n_elements() / dim;

    std::vector<types::global_dof_index> dofs(dim * n_vertices), global_vertices;
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int v = 0; v < n_vertices; ++v)
            {
              global_vertices.push_back(dofs[dim * v] / dim);
              if (!local_nodes.owns(global_vertices.back()))
                local_nodes.ghosts.push_back(global_vertices.back());
            }
        }
    local_nodes.sort_ghosts();

    // All components of a node hang alike.
    using Line = AffineConstraints<double>::ConstraintLine;
    std::vector<const Line *> lines;
    LocalNodes                with_masters = local_nodes;
    for (const Line &line : discretization.hanging_node_constraints().get_lines())
      if (line.index % dim == 0 && local_nodes.local(line.index / dim) < local_nodes.size())
        {
          lines.push_back(&line);
          for (const auto &[dof, weight] : line.entries)
            if (!local_nodes.owns(dof / dim))
              with_masters.ghosts.push_back(dof / dim);
        }
    with_masters.sort_ghosts();
    local_nodes = std::move(with_masters);

    cell_vertices.reserve(global_vertices.size());
    for (const auto global : global_vertices)
      cell_vertices.push_back(local_nodes.local(global));
    parts_start.assign(local_nodes.size() + 1, 1);
    parts_start[0] = 0;
    for (const Line *line : lines)
      parts_start[local_nodes.local(line->index / dim) + 1] = line->entries.size();
    std::partial_sum(parts_start.begin(), parts_start.end(), parts_start.begin());
    all_parts.resize(parts_start.back());
    for (unsigned int node = 0; node < local_nodes.size(); ++node)
      all_parts[parts_start[node]] = {node, 1.};
    for (const Line *line : lines)
      {
        unsigned int next = parts_start[local_nodes.local(line->index / dim)];
        for (const auto &[dof, weight] : line->entries)
          all_parts[next++] = {local_nodes.local(dof / dim), weight};
      }
  }


  template <int dim>
  void CellCouplings<dim>::coupled_nodes(const unsigned int        *vertices,
                                         std::vector<unsigned int> &nodes) const
  {
    nodes.clear();
    for (unsigned int v = 0; v < n_vertices; ++v)
      for (const auto &[node, weight] : parts(vertices[v]))
        nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }


  template <int dim>
  NodePattern CellCouplings<dim>::pattern() const
  {
    // The nodes of each cell, and from them the cells of each node.
    std::vector<unsigned int> nodes_start(1, 0), nodes, coupled,
      cells_start(local_nodes.size() + 1, 0);
    nodes.reserve(cell_vertices.size());
    for (unsigned int cell = 0; cell < is_resolved.size(); ++cell)
      {
        if (is_resolved[cell])
          {
            coupled_nodes(vertices(cell), coupled);
            nodes.insert(nodes.end(), coupled.begin(), coupled.end());
          }
        else
          nodes.insert(nodes.end(), vertices(cell), vertices(cell) + n_vertices);
        nodes_start.push_back(nodes.size());
      }
    for (const unsigned int node : nodes)
      ++cells_start[node + 1];
    std::partial_sum(cells_start.begin(), cells_start.end(), cells_start.begin());
    std::vector<unsigned int> cells(nodes.size()), next(cells_start.begin(), cells_start.end() - 1);
    for (unsigned int cell = 0; cell < is_resolved.size(); ++cell)
      for (unsigned int k = nodes_start[cell]; k < nodes_start[cell + 1]; ++k)
        cells[next[nodes[k]]++] = cell;

    NodePattern result;
    result.n_owned = local_nodes.n_owned;
    result.n_local = local_nodes.size();
    result.row_start.assign(1, 0);
    std::vector<unsigned int> last_row(local_nodes.size(), numbers::invalid_unsigned_int);
    for (unsigned int row = 0; row < local_nodes.size(); ++row)
      {
        for (unsigned int c = cells_start[row]; c < cells_start[row + 1]; ++c)
          for (unsigned int k = nodes_start[cells[c]]; k < nodes_start[cells[c] + 1]; ++k)
            if (nodes[k] >= row && last_row[nodes[k]] != row)
              {
                last_row[nodes[k]] = row;
                result.columns.push_back(nodes[k]);
              }
        std::sort(result.columns.begin() + result.row_start.back(), result.columns.end());
        result.row_start.push_back(result.columns.size());
      }
    return result;
  }


  template class CellCouplings<2>;
  template class CellCouplings<3>;
} // namespace signorini
