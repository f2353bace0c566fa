// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/multilevel.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

#include <cmath>

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

    template <int dim>
    constexpr unsigned int n_rigid_motions = dim *(dim + 1) / 2;

    /** 1 where a Dirichlet condition prescribes a Cartesian component, else 0; with ghosts. */
    template <int dim>
    Vector dirichlet_components(const Discretization<dim>     &discretization,
                                const ContactCoordinates<dim> &coordinates)
    {
      const std::vector<char> components = coordinates.prescribed_components();
      Vector                  held       = discretization.make_vector();
      for (unsigned int i = 0; i < components.size(); ++i)
        held.local_element(i) = components[i];
      held.update_ghost_values();
      return held;
    }


    /**
     * Translations, then rotations of each body about its middle, in units of its size: one vector
     * of all owned entries behind the other.
     */
    template <int dim>
    std::vector<double> rigid_motions(const Discretization<dim>       &discretization,
                                      const std::vector<unsigned int> &bodies)
    {
      const unsigned int  n = dim * bodies.size();
      std::vector<double> modes(n_rigid_motions<dim> * n, 0.);
      for (unsigned int node = 0; node < bodies.size(); ++node)
        {
          for (unsigned int c = 0; c < dim; ++c)
            modes[c * n + dim * node + c] = 1.;
          if (discretization.matrices().pattern.is_empty(node))
            continue; // a hanging node is of no body
          const auto x = (discretization.node_positions()[node]
                          - discretization.mesh().bounding_box(bodies[node]).center())
                         / discretization.mesh().body_size(bodies[node]);
          for (unsigned int k = dim; k < n_rigid_motions<dim>; ++k)
            {
              const unsigned int axis = dim == 2 ? 2 : k - dim;
              const unsigned int a = (axis + 1) % 3, b = (axis + 2) % 3;
              modes[k * n + dim * node + a] = -x[b];
              modes[k * n + dim * node + b] = x[a];
            }
        }
      return modes;
    }
  } // namespace


  template <int dim>
  template <typename SumOf>
  void Multilevel<dim>::assemble(const ElasticMatrices<dim> &matrices,
                                 const SumOf                &sum_of,
                                 const Vector               *held)
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
    const auto is_held = [&](const types::global_dof_index dof) {
      return held != nullptr && held->local_element(partitioner.global_to_local(dof)) != 0.;
    };
    for_each_entry([&](const auto         row,
                       const auto         column,
                       const unsigned int node,
                       const unsigned int k,
                       const unsigned int entry) {
      const double value = matrices.combined_block(node, k, sum_of(node))[entry];
      matrix.set(row, column, row != column && (is_held(row) || is_held(column)) ? 0. : value);
    });
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      if (pattern.is_empty(node)) // a hanging node
        for (unsigned int c = 0; c < dim; ++c)
          {
            const auto row = partitioner.local_to_global(dim * node + c);
            matrix.set(row, row, 1.);
          }
    matrix.compress(VectorOperation::insert);
    mask.assign(owned.n_elements(), 0);
  }


  template <int dim>
  Multilevel<dim>::Multilevel(const ElasticMatrices<dim>    &matrices,
                              const ContactCoordinates<dim> &coordinates,
                              const MatrixSum               &sum)
    : coordinates(coordinates)
    , cartesian(matrices.pattern.partitioner)
  {
    assemble(
      matrices, [&](unsigned int) { return sum; }, nullptr);
    multigrid.initialize(matrix, multigrid_parameters<dim>(mask.size()));
  }


  template <int dim>
  Multilevel<dim>::Multilevel(const Discretization<dim>     &discretization,
                              const ContactCoordinates<dim> &coordinates,
                              const std::vector<double>     &mass_factors)
    : coordinates(coordinates)
    , cartesian(discretization.make_vector())
  {
    const Vector                    held   = dirichlet_components(discretization, coordinates);
    const std::vector<unsigned int> bodies = discretization.bodies_of_nodes();
    assemble(
      discretization.matrices(),
      [&](const unsigned int node) {
        return MatrixSum{mass_factors[bodies[node]], 1.};
      },
      &held);

    Teuchos::ParameterList              parameters;
    std::unique_ptr<Epetra_MultiVector> constant_modes;
    multigrid_parameters<dim>(mask.size())
      .set_parameters(parameters, constant_modes, matrix.trilinos_matrix());
    std::vector<double> modes = rigid_motions(discretization, bodies);
    modes.reserve(1); // ML wants an address from processes without nodes, too
    // No coupling is weak: cells of slender bodies may be thin, and what bends them is not.
    parameters.set("aggregation: threshold", 0.);
    parameters.set("PDE equations", static_cast<int>(dim));
    parameters.set("null space: type", "pre-computed");
    parameters.set("null space: dimension", static_cast<int>(n_rigid_motions<dim>));
    parameters.set("null space: vectors", modes.data());
    multigrid.initialize(matrix, parameters);
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
