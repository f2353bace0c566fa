// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_cell_couplings_h
#define signorini_discretization_cell_couplings_h

#include <signorini/discretization/local_nodes.h>
#include <signorini/linear_algebra/node_pattern.h>

#include <deal.II/base/array_view.h>

namespace signorini
{
  template <int dim>
  class Discretization;

  /**
   * Which nodes the cells of this process couple, hanging nodes resolved. Cells count as they come
   * among the active cells that this process owns.
   */
  template <int dim>
  class CellCouplings
  {
  public:
    using Part = std::pair<unsigned int, double>; ///< a local node and its weight
    static constexpr unsigned int n_vertices = 1u << dim;

    explicit CellCouplings(const Discretization<dim> &discretization);

    /** Owned nodes, and those of others that the owned cells write to, hanging ones included. */
    const LocalNodes &nodes() const { return local_nodes; }

    /** Local nodes at the vertices of a cell. */
    const unsigned int *vertices(const unsigned int cell) const
    {
      return &cell_vertices[n_vertices * cell];
    }

    bool has_hanging_nodes(const unsigned int cell) const { return is_resolved[cell]; }

    /**
     * Local nodes that a cell with these vertices couples, ascending: its vertices, those that
     * hang replaced.
     */
    void coupled_nodes(const unsigned int *vertices, std::vector<unsigned int> &nodes) const;

    /** What a vertex is made of: itself, or the nodes that it hangs between and their weights. */
    dealii::ArrayView<const Part> parts(const unsigned int node) const
    {
      return {&all_parts[parts_start[node]], parts_start[node + 1] - parts_start[node]};
    }

    /** The upper triangle of the couplings, in compressed rows over nodes(). */
    NodePattern pattern() const;

  private:
    LocalNodes                local_nodes;
    std::vector<unsigned int> cell_vertices;
    std::vector<char>         is_resolved; ///< by cell
    std::vector<unsigned int> parts_start; ///< by local node
    std::vector<Part>         all_parts;

    bool is_hanging(const unsigned int node) const
    {
      return all_parts[parts_start[node]].first != node;
    }
    void number_nodes(const Discretization<dim> &discretization);
  };
} // namespace signorini

#endif
