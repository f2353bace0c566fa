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
      add_resolved(index, cell);
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
            add_block<dim>(sum.stiffness[k], cell.matrix->stiffness[pair], cell.stiffness_factor, a > b);
          }
      }
  }


  template <int dim>
  void CellAssembly<dim>::add_resolved(const unsigned int index, const ScaledCellMatrix<dim> &cell)
  {
    resolve(index, cell);
    for (unsigned int r = 0; r < nodes.size(); ++r)
      {
        unsigned int k = sum.pattern.row_start[nodes[r]];
        for (unsigned int s = r; s < nodes.size(); ++s)
          {
            while (sum.pattern.columns[k] != nodes[s])
              ++k;
            sum.mass[k] += mass[r * nodes.size() + s];
            add_block<dim>(sum.stiffness[k], stiffness[r * nodes.size() + s], 1., false);
          }
      }
  }


  template <int dim>
  void CellAssembly<dim>::resolve(const unsigned int index, const ScaledCellMatrix<dim> &cell)
  {
    nodes                = couplings.coupled_nodes(index);
    const unsigned int n = nodes.size();
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        parts[v].clear();
        for (const auto &[node, weight] : couplings.parts(couplings.vertices(index)[v]))
          parts[v].emplace_back(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin(), weight);
      }
    mass.assign(n * n, 0.);
    stiffness.assign(n * n, {});
    for (unsigned int a = 0; a < n_vertices; ++a)
      for (unsigned int b = 0; b < n_vertices; ++b)
        {
          const unsigned int pair = CellMatrix<dim>::pair(std::min(a, b), std::max(a, b));
          for (const auto &[r, row_weight] : parts[a])
            for (const auto &[s, column_weight] : parts[b])
              if (r <= s)
                {
                  const double weight = row_weight * column_weight;
                  mass[n * r + s] += weight * cell.mass_factor * cell.matrix->mass[pair];
                  add_block<dim>(
                    stiffness[n * r + s], cell.matrix->stiffness[pair], weight * cell.stiffness_factor, a > b);
                }
        }
  }


  template class CellAssembly<2>;
  template class CellAssembly<3>;
} // namespace signorini
