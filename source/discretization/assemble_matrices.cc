// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/assemble_matrices.h>
#include <signorini/discretization/cell_couplings.h>
#include <signorini/discretization/complete_rows.h>
#include <signorini/discretization/discretization.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Fill, with room to grow: a mesh that becomes a little finer shall not have to ask the system for memory. */
    template <typename T>
    void assign_with_room(std::vector<T> &values, const std::size_t size, const T &value)
    {
      if (values.capacity() < size && values.capacity() > 0)
        {
          values.clear();
          values.reserve(size + size / 2);
        }
      values.assign(size, value);
    }


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


    /** Add a matrix of a cell without hanging nodes to the upper triangle. */
    template <int dim>
    void add_cell(const ScaledCellMatrix<dim> &cell, const unsigned int *vertices, ElasticMatrices<dim> &matrices)
    {
      constexpr unsigned int                                        n_vertices = CellMatrix<dim>::n_vertices;
      std::array<std::pair<unsigned int, unsigned int>, n_vertices> nodes; // with their vertices
      for (unsigned int v = 0; v < n_vertices; ++v)
        nodes[v] = {vertices[v], v};
      std::sort(nodes.begin(), nodes.end());
      for (unsigned int r = 0; r < n_vertices; ++r)
        {
          unsigned int k = matrices.pattern.row_start[nodes[r].first];
          for (unsigned int s = r; s < n_vertices; ++s)
            {
              while (matrices.pattern.columns[k] != nodes[s].first)
                ++k;
              const unsigned int a = nodes[r].second, b = nodes[s].second;
              const unsigned int pair = CellMatrix<dim>::pair(std::min(a, b), std::max(a, b));
              matrices.mass[k] += cell.mass_factor * cell.matrix->mass[pair];
              add_block<dim>(matrices.stiffness[k], cell.matrix->stiffness[pair], cell.stiffness_factor, a > b);
            }
        }
    }


    /** Add a matrix of a cell with hanging nodes: what belongs to them is shared by the nodes that they hang between. */
    template <int dim>
    void add_resolved_cell(const ScaledCellMatrix<dim> &cell,
                           const CellCouplings<dim>    &couplings,
                           const unsigned int           index,
                           ElasticMatrices<dim>        &matrices)
    {
      const NodePattern &pattern = matrices.pattern;
      const auto         add = [&](const unsigned int row, const unsigned int column, const double weight, auto pair) {
        if (row > column)
          return;
        const auto         begin = pattern.columns.begin();
        const unsigned int k =
          std::lower_bound(begin + pattern.row_start[row], begin + pattern.row_start[row + 1], column) - begin;
        matrices.mass[k] += weight * cell.mass(pair.first, pair.second);
        add_block<dim>(matrices.stiffness[k], cell.stiffness(pair.first, pair.second), weight, false);
      };
      for (unsigned int a = 0; a < CellMatrix<dim>::n_vertices; ++a)
        for (unsigned int b = 0; b < CellMatrix<dim>::n_vertices; ++b)
          for (const auto &[row, row_weight] : couplings.parts(couplings.vertices(index)[a]))
            for (const auto &[column, column_weight] : couplings.parts(couplings.vertices(index)[b]))
              add(row, column, row_weight * column_weight, std::make_pair(a, b));
    }
  } // namespace


  template <int dim>
  void
  assemble_matrices(const Discretization<dim> &discretization, ElasticMatrices<dim> &matrices, const MassChange &change)
  {
    const MPI_Comm           communicator = discretization.communicator();
    const bool               mass_changes = Utilities::MPI::logical_or(!change.empty(), communicator);
    const bool               is_alone     = Utilities::MPI::n_mpi_processes(communicator) == 1;
    const CellCouplings<dim> couplings(discretization);

    // What the cells of this process contribute is all, if nobody else contributes.
    ElasticMatrices<dim>  parts;
    ElasticMatrices<dim> &sum = is_alone && !mass_changes ? matrices : parts;
    sum.pattern               = couplings.pattern();
    assign_with_room(sum.mass, sum.pattern.columns.size(), 0.);
    assign_with_room(sum.stiffness, sum.pattern.columns.size() + 1, {}); // a spare block, see Lanes
    unsigned int index = 0;
    for (const auto &cell : discretization.triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const ScaledCellMatrix<dim> cell_matrix = discretization.cell_matrices.of(cell);
          if (couplings.has_hanging_nodes(index))
            add_resolved_cell(cell_matrix, couplings, index, sum);
          else
            add_cell(cell_matrix, couplings.vertices(index), sum);
          ++index;
        }

    matrices.standard_mass.clear();
    matrices.massless_nodes.clear();
    if (&sum == &matrices)
      matrices.pattern.partitioner = make_partitioner<dim>(couplings.nodes(), communicator);
    else
      complete_rows<dim>(parts, couplings.nodes(), change, mass_changes, communicator, matrices);
  }


  template void assemble_matrices(const Discretization<2> &, ElasticMatrices<2> &, const MassChange &);
  template void assemble_matrices(const Discretization<3> &, ElasticMatrices<3> &, const MassChange &);
} // namespace signorini
