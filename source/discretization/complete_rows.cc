// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/complete_rows.h>
#include <signorini/discretization/node_owners.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/array.hpp>

#include <tuple>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    using Node = types::global_dof_index;

    /** An entry of the matrices on its way, by global nodes. */
    template <int dim>
    struct Entry
    {
      Node                                 row, column;
      double                               mass, mass_change;
      typename ElasticMatrices<dim>::Block stiffness;

      Entry transposed() const
      {
        Entry result = *this;
        std::swap(result.row, result.column);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            result.stiffness[dim * d + c] = stiffness[dim * c + d];
        return result;
      }

      /** For the compiler only: vectors of entries travel byte by byte. */
      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &row &column &mass &mass_change &stiffness;
      }
    };

    template <int dim>
    using Messages = std::map<unsigned int, std::vector<Entry<dim>>>;


    /** What the rows of other processes get from the cells of this one. */
    template <int dim>
    Messages<dim> contributions_to_others(const ElasticMatrices<dim> &matrices,
                                          const LocalNodes           &nodes,
                                          const NodeOwners           &owner)
    {
      Messages<dim>             result;
      const NodePattern        &pattern = matrices.pattern;
      std::vector<unsigned int> owner_of_ghost;
      for (const Node ghost : nodes.ghosts)
        owner_of_ghost.push_back(owner(ghost));
      for (unsigned int row = 0; row < pattern.n_local; ++row)
        for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
          if (const unsigned int column = pattern.columns[k]; column >= nodes.n_owned)
            {
              const Entry<dim>   entry{nodes.global(row),
                                     nodes.global(column),
                                     matrices.mass[k],
                                     0.,
                                     matrices.stiffness[k]};
              const unsigned int owner_of_column = owner_of_ghost[column - nodes.n_owned];
              if (row < nodes.n_owned)
                result[owner_of_column].push_back(entry.transposed());
              else
                {
                  const unsigned int owner_of_row = owner_of_ghost[row - nodes.n_owned];
                  result[owner_of_row].push_back(entry);
                  if (owner_of_column != owner_of_row)
                    result[owner_of_column].push_back(entry.transposed());
                }
            }
      return result;
    }


    /** Entries with local columns, by local row; what belongs together is side by side. */
    template <int dim>
    void sort_by_rows(std::vector<Entry<dim>> &entries, const LocalNodes &nodes)
    {
      for (Entry<dim> &entry : entries)
        {
          entry.row    = nodes.local(entry.row);
          entry.column = nodes.local(entry.column);
        }
      std::stable_sort(
        entries.begin(), entries.end(), [](const Entry<dim> &a, const Entry<dim> &b) {
          return std::tie(a.row, a.column) < std::tie(b.row, b.column);
        });
    }


    /** Rows that grow at their end. */
    template <int dim>
    class Rows
    {
    public:
      /** @param n_entries that there will be, or a few more */
      Rows(ElasticMatrices<dim> &matrices, const std::size_t n_entries)
        : matrices(matrices)
      {
        matrices.pattern.row_start.assign(1, 0);
        matrices.pattern.columns.clear();
        matrices.mass.clear();
        matrices.standard_mass.clear();
        matrices.stiffness.clear();
        matrices.pattern.columns.reserve(n_entries);
        matrices.standard_mass.reserve(n_entries);
        mass_changes.reserve(n_entries);
        matrices.stiffness.reserve(n_entries + 1);
      }

      /** Columns have to come in ascending order; the same one again adds up. */
      void add(const Entry<dim> &entry)
      {
        auto &columns = matrices.pattern.columns;
        if (columns.size() == matrices.pattern.row_start.back() || columns.back() != entry.column)
          {
            columns.push_back(entry.column);
            matrices.standard_mass.push_back(entry.mass);
            mass_changes.push_back(entry.mass_change);
            matrices.stiffness.push_back(entry.stiffness);
            return;
          }
        matrices.standard_mass.back() += entry.mass;
        mass_changes.back() += entry.mass_change;
        for (unsigned int i = 0; i < entry.stiffness.size(); ++i)
          matrices.stiffness.back()[i] += entry.stiffness[i];
      }

      void end_row() { matrices.pattern.row_start.push_back(matrices.pattern.columns.size()); }

      Entry<dim> entry(const unsigned int k) const
      {
        return {0, 0, matrices.standard_mass[k], mass_changes[k], matrices.stiffness[k]};
      }

      void finish(const bool with_change)
      {
        matrices.stiffness.emplace_back(); // a spare block, see Lanes
        if (!with_change)
          {
            matrices.mass          = std::move(matrices.standard_mass);
            matrices.standard_mass = {};
            return;
          }
        matrices.mass = matrices.standard_mass;
        for (unsigned int k = 0; k < mass_changes.size(); ++k)
          matrices.mass[k] += mass_changes[k];
      }

    private:
      ElasticMatrices<dim> &matrices;
      std::vector<double>   mass_changes;
    };


    /** The finished rows that others have as ghosts, as far as their ghosts can be columns. */
    template <int dim>
    Messages<dim> rows_for_others(const NodePattern &pattern,
                                  const Rows<dim>   &rows,
                                  const LocalNodes  &nodes,
                                  const NodeOwners  &owner)
    {
      Messages<dim> result;
      // Whose ghosts are which owned nodes: rank by rank, dim entries per node.
      std::vector<unsigned int> imported;
      for (const auto &[begin, end] : pattern.partitioner->import_indices())
        for (unsigned int i = begin; i < end; i += dim)
          imported.push_back(i / dim);
      auto first = imported.begin();
      for (const auto &[rank, n_entries] : pattern.partitioner->import_targets())
        {
          const std::vector<unsigned int> wanted(first, first + n_entries / dim);
          first += n_entries / dim;
          std::vector<Entry<dim>> &message = result[rank];
          for (const unsigned int row : wanted)
            for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
              {
                const unsigned int column = pattern.columns[k];
                if (column < pattern.n_owned
                      ? std::binary_search(wanted.begin(), wanted.end(), column)
                      : owner(nodes.global(column)) != rank)
                  {
                    message.push_back(rows.entry(k));
                    message.back().row    = nodes.global(row);
                    message.back().column = nodes.global(column);
                  }
              }
        }
      return result;
    }


    template <int dim>
    std::vector<Entry<dim>> exchange(const MPI_Comm communicator, const Messages<dim> &messages)
    {
      std::vector<Entry<dim>> result;
      for (const auto &[rank, entries] : Utilities::MPI::some_to_some(communicator, messages))
        result.insert(result.end(), entries.begin(), entries.end());
      return result;
    }
  } // namespace


  template <int dim>
  std::shared_ptr<const Utilities::MPI::Partitioner> make_partitioner(const LocalNodes &nodes,
                                                                      const MPI_Comm communicator)
  {
    const Node n_nodes = Utilities::MPI::sum(Node(nodes.n_owned), communicator);
    IndexSet   owned(dim * n_nodes), ghosts(dim * n_nodes);
    owned.add_range(dim * nodes.first_owned, dim * (nodes.first_owned + nodes.n_owned));
    for (const Node ghost : nodes.ghosts)
      ghosts.add_range(dim * ghost, dim * (ghost + 1));
    ghosts.compress();
    return std::make_shared<Utilities::MPI::Partitioner>(owned, ghosts, communicator);
  }


  template <int dim>
  void complete_rows(const ElasticMatrices<dim> &contributions,
                     const LocalNodes           &nodes,
                     const MassChange           &change,
                     const bool                  mass_changes,
                     const MPI_Comm              communicator,
                     ElasticMatrices<dim>       &result)
  {
    const NodeOwners        owner(nodes.n_owned, communicator);
    std::vector<Entry<dim>> additions =
      exchange<dim>(communicator, contributions_to_others(contributions, nodes, owner));
    for (const auto &[place, value] : change)
      if (!nodes.owns(place.second) || place.second >= place.first)
        additions.push_back({place.first, place.second, 0., value, {}});

    LocalNodes all_nodes = nodes;
    for (const Entry<dim> &entry : additions)
      if (!nodes.owns(entry.column))
        all_nodes.ghosts.push_back(entry.column);
    all_nodes.sort_ghosts();
    sort_by_rows(additions, all_nodes);

    result.pattern.n_owned     = all_nodes.n_owned;
    result.pattern.n_local     = all_nodes.size();
    result.pattern.partitioner = make_partitioner<dim>(all_nodes, communicator);
    Rows<dim> rows(result, contributions.pattern.columns.size() + additions.size());
    auto      addition = additions.begin();
    for (unsigned int row = 0; row < all_nodes.n_owned; ++row)
      {
        const NodePattern &pattern = contributions.pattern;
        for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
          {
            const unsigned int column = all_nodes.local(nodes.global(pattern.columns[k]));
            for (; addition != additions.end() && addition->row == row && addition->column < column;
                 ++addition)
              rows.add(*addition);
            rows.add({row, column, contributions.mass[k], 0., contributions.stiffness[k]});
          }
        for (; addition != additions.end() && addition->row == row; ++addition)
          rows.add(*addition);
        rows.end_row();
      }

    std::vector<Entry<dim>> imported =
      exchange<dim>(communicator, rows_for_others(result.pattern, rows, all_nodes, owner));
    sort_by_rows(imported, all_nodes);
    auto entry = imported.begin();
    for (unsigned int row = all_nodes.n_owned; row < all_nodes.size(); ++row)
      {
        for (; entry != imported.end() && entry->row == row; ++entry)
          if (entry->column >= row && entry->column < all_nodes.size())
            rows.add(*entry);
        rows.end_row();
      }
    rows.finish(mass_changes);
  }


#define INSTANTIATE(dim)                                                                           \
  template void complete_rows(const ElasticMatrices<dim> &,                                        \
                              const LocalNodes &,                                                  \
                              const MassChange &,                                                  \
                              bool,                                                                \
                              MPI_Comm,                                                            \
                              ElasticMatrices<dim> &);                                             \
  template std::shared_ptr<const Utilities::MPI::Partitioner> make_partitioner<dim>(               \
    const LocalNodes &, MPI_Comm);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
