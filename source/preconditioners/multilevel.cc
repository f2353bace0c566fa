// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/multilevel.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * Trilinos' form of a pattern. Row by row, because GCC and Clang give different names to the
     * template of deal.II that would do it, so that a program compiled by one of them does not link
     * to a deal.II compiled by the other.
     */
    TrilinosWrappers::SparsityPattern trilinos_pattern(const DynamicSparsityPattern &sparsity,
                                                       const IndexSet               &owned,
                                                       const MPI_Comm                communicator)
    {
      TrilinosWrappers::SparsityPattern result(owned, communicator, sparsity.max_entries_per_row());
      std::vector<types::global_dof_index> columns;
      for (const auto row : owned)
        {
          columns.resize(sparsity.row_length(row));
          for (unsigned int k = 0; k < columns.size(); ++k)
            columns[k] = sparsity.column_number(row, k);
          result.add_entries(row, columns.begin(), columns.end(), true);
        }
      result.compress();
      return result;
    }

    /** Of smoothed aggregation for elasticity; translations are in the near null space. */
    template <int dim>
    TrilinosWrappers::PreconditionAMG::AdditionalData
    multigrid_parameters(const unsigned int n_entries)
    {
      TrilinosWrappers::PreconditionAMG::AdditionalData data;
      data.elliptic              = true;
      data.higher_order_elements = false;
      data.smoother_sweeps       = 2;
      data.aggregation_threshold = 0.02;
      std::vector<std::vector<bool>> constant_modes(dim, std::vector<bool>(n_entries, false));
      for (unsigned int i = 0; i < n_entries; ++i)
        constant_modes[i % dim][i] = true;
      data.constant_modes = constant_modes;
      return data;
    }
  } // namespace


  template <int dim>
  Multilevel<dim>::Multilevel(const ElasticMatrices<dim>    &matrices,
                              const ContactCoordinates<dim> &coordinates,
                              const MatrixSum               &sum)
    : coordinates(coordinates)
    , cartesian(matrices.pattern.partitioner)
  {
    const NodePattern &pattern        = matrices.pattern;
    const auto        &partitioner    = *pattern.partitioner;
    const IndexSet    &owned          = partitioner.locally_owned_range();
    const auto         for_each_entry = [&](const auto &action) {
      const auto dof = [&](const unsigned int node, const unsigned int c) {
        return partitioner.local_to_global(dim * node + c);
      };
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              {
                action(dof(node, c), dof(pattern.columns[k], d), node, k, dim * d + c);
                if (pattern.columns[k] != node && pattern.columns[k] < pattern.n_owned)
                  action(dof(pattern.columns[k], d), dof(node, c), node, k, dim * d + c);
              }
    };
    DynamicSparsityPattern sparsity(owned.size(), owned.size(), owned);
    for_each_entry(
      [&](const auto row, const auto column, unsigned int, unsigned int, unsigned int) {
        sparsity.add(row, column);
      });
    for (const auto row : owned)
      sparsity.add(row, row);
    matrix.reinit(trilinos_pattern(sparsity, owned, cartesian.get_mpi_communicator()));
    for_each_entry([&](const auto         row,
                       const auto         column,
                       const unsigned int node,
                       const unsigned int k,
                       const unsigned int entry) {
      matrix.set(row, column, matrices.combined_block(node, k, sum)[entry]);
    });
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (pattern.is_empty(node)) // a hanging node
        for (unsigned int c = 0; c < dim; ++c)
          {
            const auto row = partitioner.local_to_global(dim * node + c);
            matrix.set(row, row, 1.);
          }
    matrix.compress(VectorOperation::insert);

    multigrid.initialize(matrix, multigrid_parameters<dim>(owned.n_elements()));
    mask.assign(owned.n_elements(), 0);
  }


  template <int dim>
  void Multilevel<dim>::vmult(Vector &destination, const Vector &source) const
  {
    cartesian.copy_locally_owned_data_from(source);
    for (unsigned int i = 0; i < mask.size(); ++i)
      if (mask[i])
        cartesian.local_element(i) = 0.;
    coordinates.force_to_cartesian(cartesian);
    destination.zero_out_ghost_values();
    multigrid.vmult(destination, cartesian);
    coordinates.displacement_to_contact(destination);
    for (unsigned int i = 0; i < mask.size(); ++i)
      if (mask[i])
        destination.local_element(i) = 0.;
  }


  template class Multilevel<2>;
  template class Multilevel<3>;
} // namespace signorini
