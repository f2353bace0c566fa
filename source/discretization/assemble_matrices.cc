// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/assemble_matrices.h>
#include <signorini/discretization/discretization.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <deal.II/dofs/dof_tools.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** The hanging node constraints seen as constraints of nodes: those of the first component. */
    template <int dim>
    AffineConstraints<double> node_constraints(const AffineConstraints<double> &constraints,
                                               const IndexSet                  &relevant_nodes)
    {
      AffineConstraints<double> result(relevant_nodes);
      for (const auto &line : constraints.get_lines())
        if (line.index % dim == 0)
          {
            result.add_line(line.index / dim);
            for (const auto &[master, weight] : line.entries)
              result.add_entry(line.index / dim, master / dim, weight);
          }
      result.close();
      return result;
    }


    /** Indices of nodes from indices of degrees of freedom. */
    template <int dim>
    IndexSet nodes_of(const IndexSet &dofs)
    {
      IndexSet nodes(dofs.size() / dim);
      for (auto interval = dofs.begin_intervals(); interval != dofs.end_intervals(); ++interval)
        nodes.add_range(*interval->begin() / dim, interval->last() / dim + 1);
      nodes.compress();
      return nodes;
    }


    /** Element matrices of one cell: mass per pair of vertices, stiffness per pair of degrees of freedom. */
    template <int dim>
    void element_matrices(const FEValues<dim> &fe_values,
                          const Material      &material,
                          FullMatrix<double>  &mass,
                          FullMatrix<double>  &stiffness)
    {
      const unsigned int n_vertices = fe_values.dofs_per_cell;
      const double       lambda = material.lambda(), mu = material.mu();
      mass      = 0.;
      stiffness = 0.;
      for (const unsigned int q : fe_values.quadrature_point_indices())
        for (unsigned int a = 0; a < n_vertices; ++a)
          for (unsigned int b = 0; b < n_vertices; ++b)
            {
              const Tensor<1, dim> &grad_a = fe_values.shape_grad(a, q), &grad_b = fe_values.shape_grad(b, q);
              const double          JxW = fe_values.JxW(q);
              mass(a, b) += material.density * fe_values.shape_value(a, q) * fe_values.shape_value(b, q) * JxW;
              const double laplace = mu * (grad_a * grad_b) * JxW;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  for (unsigned int d = 0; d < dim; ++d)
                    stiffness(dim * a + c, dim * b + d) +=
                      (lambda * grad_a[c] * grad_b[d] + mu * grad_a[d] * grad_b[c]) * JxW;
                  stiffness(dim * a + c, dim * b + c) += laplace;
                }
            }
    }


    /** The rows of owned nodes and ghosts of a distributed matrix on this process. */
    Epetra_CrsMatrix rows_with_ghosts(const TrilinosWrappers::SparseMatrix &matrix, const Epetra_Map &rows)
    {
      const Epetra_CrsMatrix &source = matrix.trilinos_matrix();
      Epetra_CrsMatrix        result(Copy, rows, 0);
      result.Import(source, Epetra_Import(rows, source.RowMap()), Insert);
      result.FillComplete(source.DomainMap(), source.RangeMap());
      return result;
    }


    Epetra_Map make_map(const IndexSet &owned, const IndexSet &ghosts, const Epetra_Map &like)
    {
      std::vector<int> indices;
      for (const auto i : owned)
        indices.push_back(i);
      for (const auto i : ghosts)
        indices.push_back(i);
      return Epetra_Map(-1, indices.size(), indices.data(), 0, like.Comm());
    }
  } // namespace


  template <int dim>
  void
  assemble_matrices(const Discretization<dim> &discretization, ElasticMatrices<dim> &matrices, const MassChange &change)
  {
    const auto     &dof_handler  = discretization.dof_handler;
    const auto     &constraints  = discretization.hanging_node_constraints;
    const IndexSet &owned        = discretization.locally_owned;
    const MPI_Comm  communicator = discretization.communicator();
    const IndexSet  owned_nodes = nodes_of<dim>(owned), relevant_nodes = nodes_of<dim>(discretization.locally_relevant);
    const auto      constraints_of_nodes = node_constraints<dim>(constraints, relevant_nodes);

    const FE_Q<dim>    scalar_fe(1);
    FEValues<dim>      fe_values(discretization.mapping,
                            scalar_fe,
                            QGauss<dim>(discretization.n_quadrature_points()),
                            update_values | update_gradients | update_JxW_values);
    const unsigned int n_vertices = scalar_fe.n_dofs_per_cell();
    FullMatrix<double> cell_mass(n_vertices, n_vertices), cell_stiffness(dim * n_vertices, dim * n_vertices);
    std::vector<types::global_dof_index> dofs(dim * n_vertices), nodes(n_vertices);
    const auto                           get_indices = [&](const auto &cell) {
      cell->get_dof_indices(dofs);
      for (unsigned int v = 0; v < n_vertices; ++v)
        nodes[v] = dofs[dim * v] / dim;
    };

    DynamicSparsityPattern node_sparsity(relevant_nodes);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          get_indices(cell);
          constraints_of_nodes.add_entries_local_to_global(nodes, node_sparsity, false);
        }
    SparsityTools::distribute_sparsity_pattern(node_sparsity, owned_nodes, communicator, relevant_nodes);
    for (const auto &[entry, value] : change)
      node_sparsity.add(entry.first, entry.second);
    DynamicSparsityPattern dof_sparsity(owned);
    dof_sparsity.reinit(owned.size(), owned.size(), owned);
    for (const auto node : owned_nodes)
      {
        std::vector<types::global_dof_index> row;
        for (auto entry = node_sparsity.begin(node); entry != node_sparsity.end(node); ++entry)
          for (unsigned int c = 0; c < dim; ++c)
            row.push_back(dim * entry->column() + c);
        for (unsigned int c = 0; c < dim; ++c)
          dof_sparsity.add_entries(dim * node + c, row.begin(), row.end(), true);
      }
    TrilinosWrappers::SparseMatrix mass, stiffness;
    mass.reinit(owned_nodes, owned_nodes, node_sparsity, communicator, true);
    stiffness.reinit(owned, owned, dof_sparsity, communicator, true);

    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(static_cast<typename Triangulation<dim>::cell_iterator>(cell));
          element_matrices(
            fe_values, discretization.scene.bodies[cell->material_id()].material, cell_mass, cell_stiffness);
          get_indices(cell);
          constraints_of_nodes.distribute_local_to_global(cell_mass, nodes, mass);
          constraints.distribute_local_to_global(cell_stiffness, dofs, stiffness);
        }
    mass.compress(VectorOperation::add);
    stiffness.compress(VectorOperation::add);

    // Ghosts: all nodes that are coupled with an owned one, and all that the owned cells write to.
    IndexSet          ghost_nodes(owned_nodes.size()), ghosts(owned.size());
    const Epetra_Map &column_map = mass.trilinos_matrix().ColMap();
    for (int i = 0; i < column_map.NumMyElements(); ++i)
      if (!owned_nodes.is_element(column_map.GID(i)))
        {
          ghost_nodes.add_index(column_map.GID(i));
          ghosts.add_range(dim * column_map.GID(i), dim * (column_map.GID(i) + 1));
        }
    IndexSet active;
    DoFTools::extract_locally_active_dofs(dof_handler, active);
    const auto add_ghost = [&](const types::global_dof_index node) {
      if (!owned_nodes.is_element(node))
        {
          ghost_nodes.add_index(node);
          ghosts.add_range(dim * node, dim * (node + 1));
        }
    };
    for (const auto node : nodes_of<dim>(active))
      {
        add_ghost(node);
        if (constraints_of_nodes.is_constrained(node))
          for (const auto &[master, weight] : *constraints_of_nodes.get_constraint_entries(node))
            add_ghost(master);
      }
    ghost_nodes.compress();
    ghosts.compress();

    const Epetra_Map      &node_map       = mass.trilinos_matrix().RowMap();
    const Epetra_Map      &dof_map        = stiffness.trilinos_matrix().RowMap();
    const Epetra_Map       local_nodes    = make_map(owned_nodes, ghost_nodes, node_map);
    const Epetra_CrsMatrix mass_rows      = rows_with_ghosts(mass, local_nodes);
    const Epetra_CrsMatrix stiffness_rows = rows_with_ghosts(stiffness, make_map(owned, ghosts, dof_map));

    NodePattern &pattern = matrices.pattern;
    pattern.partitioner  = std::make_shared<Utilities::MPI::Partitioner>(owned, ghosts, communicator);
    pattern.n_owned      = owned_nodes.n_elements();
    pattern.n_local      = pattern.n_owned + ghost_nodes.n_elements();
    pattern.row_start.assign(1, 0);
    pattern.columns.clear();
    matrices.mass.clear();
    matrices.standard_mass.clear();
    matrices.stiffness.clear();
    const auto local_node = [&](const int global) {
      return owned_nodes.is_element(global)   ? owned_nodes.index_within_set(global)
             : ghost_nodes.is_element(global) ? pattern.n_owned + ghost_nodes.index_within_set(global)
                                              : numbers::invalid_unsigned_int;
    };
    std::vector<unsigned int> position(pattern.n_local);
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      {
        int     n_entries, *columns;
        double *values;
        mass_rows.ExtractMyRowView(node, n_entries, values, columns);
        std::vector<std::pair<unsigned int, double>> row;
        const types::global_dof_index                global_node = mass_rows.GRID(node);
        const bool hanging = relevant_nodes.is_element(global_node) && constraints_of_nodes.is_constrained(global_node);
        if (!hanging)
          for (int k = 0; k < n_entries; ++k)
            if (const unsigned int column = local_node(mass_rows.GCID(columns[k]));
                column >= node && column < pattern.n_local)
              row.emplace_back(column, values[k]);
        std::sort(row.begin(), row.end());
        for (const auto &[column, value] : row)
          {
            position[column] = pattern.columns.size();
            pattern.columns.push_back(column);
            matrices.mass.push_back(value);
          }
        pattern.row_start.push_back(pattern.columns.size());
        matrices.stiffness.resize(pattern.columns.size());
        if (!row.empty())
          for (unsigned int c = 0; c < dim; ++c)
            {
              stiffness_rows.ExtractMyRowView(dim * node + c, n_entries, values, columns);
              for (int k = 0; k < n_entries; ++k)
                {
                  const int global = stiffness_rows.GCID(columns[k]);
                  if (const unsigned int column = local_node(global / dim); column >= node && column < pattern.n_local)
                    matrices.stiffness[position[column]][dim * (global % dim) + c] = values[k];
                }
            }
      }
    matrices.stiffness.emplace_back();

    if (Utilities::MPI::max(static_cast<unsigned int>(!change.empty()), communicator) == 0)
      return;
    for (const auto &[entry, value] : change)
      mass.add(entry.first, entry.second, value);
    mass.compress(VectorOperation::add);
    const Epetra_CrsMatrix changed_rows = rows_with_ghosts(mass, local_nodes);
    matrices.standard_mass.swap(matrices.mass);
    matrices.mass.assign(matrices.standard_mass.size(), 0.);
    for (unsigned int node = 0; node < pattern.n_local; ++node)
      {
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          position[pattern.columns[k]] = k;
        if (pattern.is_empty(node))
          continue;
        int     n_entries, *columns;
        double *values;
        changed_rows.ExtractMyRowView(node, n_entries, values, columns);
        for (int k = 0; k < n_entries; ++k)
          if (const unsigned int column = local_node(changed_rows.GCID(columns[k]));
              column >= node && column < pattern.n_local)
            matrices.mass[position[column]] = values[k];
      }
  }


  template void assemble_matrices(const Discretization<2> &, ElasticMatrices<2> &, const MassChange &);
  template void assemble_matrices(const Discretization<3> &, ElasticMatrices<3> &, const MassChange &);
} // namespace signorini
