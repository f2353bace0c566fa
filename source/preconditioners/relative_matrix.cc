// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/contact_rows.h>
#include <signorini/preconditioners/relative_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <set>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using SmallVector = Eigen::Matrix<double, dim, 1>;
    template <int dim>
    using SmallMatrix = Eigen::Matrix<double, dim, dim>;

    /** Blocks of a few rows, by local nodes. */
    template <int dim>
    using SparseBlocks = std::map<unsigned int, std::map<unsigned int, SmallMatrix<dim>>>;

    template <int dim>
    void add(SparseBlocks<dim>      &blocks,
             const unsigned int      row,
             const unsigned int      column,
             const SmallMatrix<dim> &block)
    {
      const auto [entry, is_new] = blocks[row].emplace(column, block);
      if (!is_new)
        entry->second += block;
    }

    /** A row of P with local nodes. */
    template <int dim>
    struct LocalRow
    {
      std::vector<SmallVector<dim>>                directions;
      std::vector<std::pair<unsigned int, double>> partners;

      /** The relative part of the rows, Pi K, and of the columns, K Pi, of a block. */
      SmallMatrix<dim> project_rows(const SmallMatrix<dim> &block) const
      {
        SmallMatrix<dim> result = SmallMatrix<dim>::Zero();
        for (const SmallVector<dim> &direction : directions)
          result += direction * (direction.transpose() * block);
        return result;
      }
      SmallMatrix<dim> project_columns(const SmallMatrix<dim> &block) const
      {
        SmallMatrix<dim> result = SmallMatrix<dim>::Zero();
        for (const SmallVector<dim> &direction : directions)
          result += block * direction * direction.transpose();
        return result;
      }
    };


    /** Owned nodes, ghosts of the matrices, and the ghosts beyond the contact surface. */
    template <int dim>
    std::shared_ptr<const Utilities::MPI::Partitioner>
    extended_partitioner(const Utilities::MPI::Partitioner  &old,
                         const std::vector<ContactRow<dim>> &rows)
    {
      std::vector<types::global_dof_index> strangers;
      const auto                           add_node = [&](const types::global_dof_index node) {
        if (!old.in_local_range(dim * node))
          strangers.push_back(node);
      };
      for (const ContactRow<dim> &row : rows)
        {
          bool owns_partner = false;
          add_node(row.node);
          for (const auto &[partner, weight] : row.partners)
            {
              add_node(partner);
              owns_partner = owns_partner || old.in_local_range(dim * partner);
            }
          if (owns_partner)
            for (const auto neighbour : row.neighbours)
              add_node(neighbour);
        }
      IndexSet ghosts = entries_of_nodes<dim>(old.size(), std::move(strangers));
      ghosts.add_indices(old.ghost_indices());
      return std::make_shared<Utilities::MPI::Partitioner>(
        old.locally_owned_range(), ghosts, old.get_mpi_communicator());
    }


    /** K with rows and columns of the extended numbering, as far as contact is concerned. */
    template <int dim>
    class InterfaceBlocks
    {
    public:
      InterfaceBlocks(const ElasticMatrices<dim>                  &matrices,
                      const MatrixSum                             &sum,
                      const std::vector<unsigned int>             &new_node,
                      const Utilities::MPI::Partitioner           &partitioner,
                      const std::map<unsigned int, LocalRow<dim>> &contact_rows,
                      const std::vector<types::global_dof_index>  &new_ghosts)
      {
        const NodePattern &pattern = matrices.pattern;
        const auto         block   = [&](const unsigned int node, const unsigned int k) {
          return SmallMatrix<dim>(
            Eigen::Map<const SmallMatrix<dim>>(matrices.combined_block(node, k, sum).data()));
        };
        for (unsigned int node = 0; node < pattern.n_local; ++node)
          for (unsigned int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
            {
              const unsigned int i = new_node[node], j = new_node[pattern.columns[k]];
              if (contact_rows.count(i) > 0)
                of_contact_nodes[i][j] = block(node, k);
              if (contact_rows.count(j) > 0)
                of_contact_nodes[j][i] = block(node, k).transpose();
            }

        for (const auto &[node, row] : import_rows(matrices, sum, new_ghosts))
          {
            const unsigned int i = partitioner.global_to_local(dim * node) / dim;
            for (const auto &[column, entries] : row)
              if (partitioner.in_local_range(dim * column)
                  || partitioner.is_ghost_entry(dim * column))
                {
                  const unsigned int     j     = partitioner.global_to_local(dim * column) / dim;
                  const SmallMatrix<dim> value = Eigen::Map<const SmallMatrix<dim>>(entries.data());
                  beyond[std::min(i, j)][std::max(i, j)] =
                    i < j ? value : SmallMatrix<dim>(value.transpose());
                  if (contact_rows.count(i) > 0)
                    of_contact_nodes[i][j] = value;
                  if (contact_rows.count(j) > 0)
                    of_contact_nodes[j][i] = value.transpose();
                }
          }
      }

      SparseBlocks<dim> of_contact_nodes; ///< full rows of K
      SparseBlocks<dim>
        beyond; ///< upper triangle: couplings of the ghosts that the matrices do not have
    };


    /** Upper triangle of S'KS - K = Y + Y' + Y N with S = I + N, Y = N'K. */
    template <int dim>
    SparseBlocks<dim> relative_part(const SparseBlocks<dim>                     &stiffness,
                                    const std::map<unsigned int, LocalRow<dim>> &contact_rows)
    {
      SparseBlocks<dim> product, result;
      for (const auto &[p, row] : contact_rows)
        if (const auto blocks = stiffness.find(p); blocks != stiffness.end())
          for (const auto &[q, block] : blocks->second)
            {
              const SmallMatrix<dim> relative = row.project_rows(block);
              for (const auto &[l, weight] : row.partners)
                add<dim>(product, l, q, weight * relative);
            }
      for (const auto &[l, blocks] : product)
        for (const auto &[q, block] : blocks)
          {
            if (l <= q)
              add<dim>(result, l, q, block);
            if (q <= l)
              add<dim>(result, q, l, block.transpose());
            if (const auto row = contact_rows.find(q); row != contact_rows.end())
              {
                const SmallMatrix<dim> relative = row->second.project_columns(block);
                for (const auto &[m, weight] : row->second.partners)
                  if (l <= m)
                    add<dim>(result, l, m, weight * relative);
              }
          }
      return result;
    }


    /**
     * The rows of a M + b A in another numbering, with additions. @param sizes its sizes are
     * given, its rows are not
     */
    template <int dim>
    ElasticMatrices<dim> merged_matrix(const ElasticMatrices<dim>      &matrices,
                                       const MatrixSum                 &sum,
                                       const std::vector<unsigned int> &new_node,
                                       SparseBlocks<dim>                additions,
                                       const NodePattern               &sizes)
    {
      const NodePattern   &old = matrices.pattern;
      ElasticMatrices<dim> result;
      NodePattern         &pattern = result.pattern;
      pattern                      = sizes;
      std::vector<unsigned int> old_node(pattern.n_local, old.n_local);
      for (unsigned int node = 0; node < old.n_local; ++node)
        old_node[new_node[node]] = node;
      pattern.row_start.assign(1, 0);
      for (unsigned int node = 0; node < pattern.n_local; ++node)
        {
          std::map<unsigned int, SmallMatrix<dim>> row;
          if (const auto addition = additions.find(node); addition != additions.end())
            row = std::move(addition->second);
          auto       next = row.begin();
          const auto push = [&](const unsigned int column, const SmallMatrix<dim> &block) {
            pattern.columns.push_back(column);
            result.stiffness.emplace_back();
            Eigen::Map<SmallMatrix<dim>>(result.stiffness.back().data()) = block;
          };
          if (const unsigned int source = old_node[node]; source < old.n_local)
            for (unsigned int k = old.row_start[source]; k < old.row_start[source + 1]; ++k)
              {
                const unsigned int column = new_node[old.columns[k]];
                for (; next != row.end() && next->first < column; ++next)
                  push(next->first, next->second);
                SmallMatrix<dim> block = Eigen::Map<const SmallMatrix<dim>>(
                  matrices.combined_block(source, k, sum).data());
                if (next != row.end() && next->first == column)
                  block += (next++)->second;
                push(column, block);
              }
          for (; next != row.end(); ++next)
            push(next->first, next->second);
          pattern.row_start.push_back(pattern.columns.size());
        }
      result.mass.assign(pattern.columns.size(), 0.);
      result.stiffness.emplace_back(); // a spare block, see Lanes
      return result;
    }
  } // namespace


  template <int dim>
  ElasticMatrices<dim> relative_matrix(const ElasticMatrices<dim>    &matrices,
                                       const ContactCoordinates<dim> &coordinates,
                                       const MatrixSum               &sum)
  {
    const NodePattern &old         = matrices.pattern;
    const auto         rows        = gather_contact_rows<dim>(old, coordinates);
    const auto         partitioner = extended_partitioner<dim>(*old.partitioner, rows);
    const auto         local_node  = [&](const types::global_dof_index node) {
      return partitioner->global_to_local(dim * node) / dim;
    };

    // Ghosts are in ascending order before and after, so that rows stay sorted.
    std::vector<unsigned int> new_node(old.n_local);
    for (unsigned int node = 0; node < old.n_local; ++node)
      new_node[node] = local_node(old.partitioner->local_to_global(dim * node) / dim);
    std::vector<types::global_dof_index> new_ghosts;
    for (const auto entry : partitioner->ghost_indices())
      if (entry % dim == 0 && !old.partitioner->is_ghost_entry(entry))
        new_ghosts.push_back(entry / dim);
    std::map<unsigned int, LocalRow<dim>> contact_rows;
    for (const ContactRow<dim> &row : rows)
      {
        LocalRow<dim> &local = contact_rows[local_node(row.node)];
        for (const auto &direction : row.directions)
          local.directions.push_back(Eigen::Map<const SmallVector<dim>>(direction.data()));
        for (const auto &[partner, weight] : row.partners)
          local.partners.emplace_back(local_node(partner), weight);
      }

    const InterfaceBlocks<dim> interface(
      matrices, sum, new_node, *partitioner, contact_rows, new_ghosts);
    SparseBlocks<dim> additions = relative_part<dim>(interface.of_contact_nodes, contact_rows);
    for (const auto &[i, blocks] : interface.beyond)
      for (const auto &[j, block] : blocks)
        add<dim>(additions, i, j, block);

    NodePattern pattern;
    pattern.partitioner = partitioner;
    pattern.n_owned     = old.n_owned;
    pattern.n_local = (partitioner->locally_owned_size() + partitioner->n_ghost_indices()) / dim;
    return merged_matrix<dim>(matrices, sum, new_node, std::move(additions), pattern);
  }


  template ElasticMatrices<2>
  relative_matrix(const ElasticMatrices<2> &, const ContactCoordinates<2> &, const MatrixSum &);
  template ElasticMatrices<3>
  relative_matrix(const ElasticMatrices<3> &, const ContactCoordinates<3> &, const MatrixSum &);
} // namespace signorini
