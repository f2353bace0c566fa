// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/cell_assembly.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    /** sum += factor block, or its transpose; blocks are stored column by column. */
    template <int dim>
    void add_block(typename ElasticMatrices<dim>::Block       &sum,
                   const typename ElasticMatrices<dim>::Block &block,
                   const double                                factor,
                   const bool                                  transposed)
    {
      if (transposed)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            sum[dim * d + c] += factor * block[dim * c + d];
      else
        for (unsigned int i = 0; i < dim * dim; ++i)
          sum[i] += factor * block[i];
    }
  } // namespace


  template <int dim>
  void CellAssembly<dim>::add(const unsigned int index, const ScaledCellMatrix<dim> &cell)
  {
    if (couplings.has_hanging_nodes(index))
      add_resolved(couplings.vertices(index), cell);
    else
      add_plain(couplings.vertices(index), cell);
  }


  template <int dim>
  void CellAssembly<dim>::add_plain(const unsigned int *vertices, const ScaledCellMatrix<dim> &cell)
  {
    std::array<std::pair<unsigned int, unsigned int>, n_vertices> ascending; // with their vertices
    for (unsigned int v = 0; v < n_vertices; ++v)
      ascending[v] = {vertices[v], v};
    std::sort(ascending.begin(), ascending.end());
    for (unsigned int r = 0; r < n_vertices; ++r)
      {
        unsigned int k = sum.pattern.row_start[ascending[r].first];
        for (unsigned int s = r; s < n_vertices; ++s)
          {
            while (sum.pattern.columns[k] != ascending[s].first)
              ++k;
            const unsigned int a = ascending[r].second, b = ascending[s].second;
            const unsigned int pair = CellMatrix<dim>::pair(std::min(a, b), std::max(a, b));
            sum.mass[k] += cell.mass_factor * cell.matrix->mass[pair];
            add_block<dim>(
              sum.stiffness[k], cell.matrix->stiffness[pair], cell.stiffness_factor, a > b);
          }
      }
  }


  template <int dim>
  void CellAssembly<dim>::add_resolved(const unsigned int          *vertices,
                                       const ScaledCellMatrix<dim> &cell)
  {
    find_places(vertices);
    for (unsigned int a = 0; a < n_vertices; ++a)
      for (unsigned int b = 0; b < n_vertices; ++b)
        {
          const unsigned int pair = CellMatrix<dim>::pair(std::min(a, b), std::max(a, b));
          for (const auto &[r, row_weight] : parts[a])
            for (const auto &[s, column_weight] : parts[b])
              if (r <= s)
                {
                  const unsigned int k      = places[r * nodes.size() + s];
                  const double       weight = row_weight * column_weight;
                  sum.mass[k] += weight * cell.mass_factor * cell.matrix->mass[pair];
                  add_block<dim>(sum.stiffness[k],
                                 cell.matrix->stiffness[pair],
                                 weight * cell.stiffness_factor,
                                 a > b);
                }
        }
  }


  template <int dim>
  void CellAssembly<dim>::find_places(const unsigned int *vertices)
  {
    couplings.coupled_nodes(vertices, nodes);
    const unsigned int n = nodes.size();
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        parts[v].clear();
        for (const auto &[node, weight] : couplings.parts(vertices[v]))
          parts[v].emplace_back(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin(),
                                weight);
      }
    places.resize(n * n);
    for (unsigned int r = 0; r < n; ++r)
      {
        unsigned int k = sum.pattern.row_start[nodes[r]];
        for (unsigned int s = r; s < n; ++s)
          {
            while (sum.pattern.columns[k] != nodes[s])
              ++k;
            places[r * n + s] = k;
          }
      }
  }


  template class CellAssembly<2>;
  template class CellAssembly<3>;
} // namespace signorini
